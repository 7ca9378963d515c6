//! Corners of tiles' collision shapes that were drawn by hand meet.

use tilesat_tools::lint::{self, Body, Rules, Severity};
use tilesat_tools::read;
use tilesat_tools::rules::flags::Flags;
use tilesat_tools::rules::ground::Ground;
use tilesat_tools::rules::options::Options;

use crate::support::{folder, run, scratch};

/// A generator of numbers, by xorshift.
struct Random(u64);

impl Random {
    /// From 0 to below `end`.
    fn below(&mut self, end: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 % end
    }

    /// Thousandths of a pixel, off by up to `most`.
    fn off(&mut self, at: i64, most: i64) -> i64 {
        at - most + self.below(2 * most as u64 + 1) as i64
    }
}

/// Thousandths of a pixel.
type Corner = (i64, i64);

/// A map of one row below an empty one. The first tile is solid, and the others have these shapes.
/// Two corners are a chain.
fn map(tiles: &[Vec<Corner>], row: &[usize]) -> String {
    let number = |v: i64| format!("{}{}.{:03}", if v < 0 { "-" } else { "" }, v.abs() / 1000, v.abs() % 1000);
    let shape = |(id, corners): (usize, &Vec<Corner>)| {
        let points: Vec<String> = corners.iter().map(|p| format!("{},{}", number(p.0), number(p.1))).collect();
        let (points, form) = (points.join(" "), if corners.len() == 2 { "polyline" } else { "polygon" });
        format!(
            r#"<tile id="{id}"><objectgroup><object id="1" x="0" y="0"><{form} points="{points}"/></object></objectgroup></tile>"#
        )
    };
    let tiles: String = (1..).zip(tiles).map(shape).collect();
    let cells: Vec<String> = row.iter().map(usize::to_string).collect();
    let (width, empty) = (row.len(), vec!["0"; row.len()].join(","));
    let cells = cells.join(",");
    format!(
        r#"<map version="1.10" orientation="orthogonal" width="{width}" height="3" tilewidth="16" tileheight="16">
 <tileset firstgid="1" name="t" tilewidth="16" tileheight="16" tilecount="99" columns="9"><tile id="0" type="Solid"/>{tiles}</tileset>
 <layer id="1" name="tiles" width="{width}" height="3"><data encoding="csv">{empty},{cells},{}</data></layer>
</map>"#,
        vec!["1"; width].join(",")
    )
}

fn ground(text: &str, weld: Option<i64>) -> Result<Ground, String> {
    let levels = read::load(&scratch("weld", "level.tmx", text), None).map_err(|fail| fail.to_string())?;
    let options = Options { weld, ..Options::default() };
    Ground::of(&levels.maps[0], &options, &mut Flags::default()).map_err(|fail| fail.to_string())
}

fn warnings(ground: &Ground) -> usize {
    let rules = Rules { body: Some(Body::Box { width: 10 << 16, height: 14 << 16 }), small: 1 << 16 };
    lint::check(ground, &rules).unwrap().count(Severity::Warning)
}

/// A ramp of 1 in 3 over three tiles, from a wall to the floor. Each corner was drawn up to 0.12
/// pixels off, so that corners of neighbours are up to 0.24 apart.
#[test]
fn a_ramp_of_three_tiles_is_one() {
    let mut random = Random(7);
    let heights = [0, 5333, 10667, 16000];
    let (mut torn, mut warned) = (0, 0);
    for case in 0..60 {
        let mut tile = |k: usize| {
            let mut corners = vec![(0, heights[k]), (16_000, heights[k + 1]), (16_000, 16_000), (0, 16_000)];
            // The last tile ends in a point.
            corners.truncate(if k == 2 { 2 } else { 4 });
            if k == 2 {
                corners.push((0, 16_000));
            }
            for p in &mut corners {
                *p = (random.off(p.0, 120), random.off(p.1, 120));
            }
            corners
        };
        let tiles = [tile(0), tile(1), tile(2)];
        let text = map(&tiles, &[1, 2, 3, 4, 0, 0]);
        let (drawn, welded) = (ground(&text, Some(0)).unwrap(), ground(&text, None).unwrap());
        torn += usize::from(drawn.outlines.len() > 1);
        warned += usize::from(warnings(&drawn) > 0);
        let [ramp] = &welded.outlines[..] else { panic!("case {case}: {welded:?}") };
        assert_eq!(warnings(&welded), 0, "case {case}: {ramp:?}");
        // The slope leaves its line by no more than the hand and the tolerance did.
        for &(x, y) in &ramp.points {
            let (x, y) = (x - (16 << 16), y - (16 << 16));
            let most = ((120 + 40 + 250) << 16) / 1000;
            let on_line = (3 * y - x).abs() <= 3 * most || (y - (16 << 16)).abs() <= most || x.abs() <= most;
            assert!(on_line, "case {case}: {x}, {y}");
        }
        let note = welded.notes.iter().find(|note| note.contains("welded")).unwrap();
        assert!(note.contains("within 0.25 px") && note.contains("--weld 0"), "{note}");
        assert!(!drawn.notes.iter().any(|note| note.contains("welded")));
    }
    // Without welding, the same drawings have gaps.
    assert!(torn == 60 && warned == 60, "{torn} {warned}");
}

/// A ramp that ends 0.15 pixels beside the corner of a half tile ends there.
#[test]
fn polygons_meet_shapes_of_the_library() {
    let ramp = vec![(0, 16_000), (16_000, 8150), (16_000, 16_000)];
    let half = vec![(0, 8000), (16_000, 8000), (16_000, 16_000), (0, 16_000)];
    let text = map(&[ramp, half], &[0, 2, 3, 1]);
    let peak = |weld| {
        let ground = ground(&text, weld).unwrap();
        let [outline] = &ground.outlines[..] else { panic!("{ground:?}") };
        outline.points.iter().map(|p| p.1).min().unwrap()
    };
    assert_eq!((peak(Some(0)), peak(None)), ((24_150 << 16) / 1000, 24 << 16));
}

/// What was drawn to meet stays, bit by bit.
#[test]
fn exact_drawings_stay() {
    let ramp = vec![(0, 0), (16_000, 5000), (16_000, 16_000), (0, 16_000)];
    let rest = vec![(0, 5000), (16_000, 9000), (16_000, 16_000), (0, 16_000)];
    let text = map(&[ramp, rest], &[1, 2, 3, 1]);
    let (drawn, welded) = (ground(&text, Some(0)).unwrap(), ground(&text, None).unwrap());
    assert_eq!(drawn, welded);
}

/// Twice the area. Positive if the points turn right.
fn area(points: &[(i64, i64)]) -> i128 {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(a, b)| i128::from(a.0) * i128::from(b.1) - i128::from(a.1) * i128::from(b.0)).sum()
}

fn is_convex(points: &[(i64, i64)]) -> bool {
    let n = points.len();
    let turn = |i: usize| area(&[points[i], points[(i + 1) % n], points[(i + 2) % n]]).signum();
    let turns: Vec<i128> = (0..n).map(turn).filter(|turn| *turn != 0).collect();
    turns.windows(2).all(|pair| pair[0] == pair[1])
}

/// The corners of a hull, by gift wrapping.
fn hull(points: &[Corner]) -> Vec<Corner> {
    let mut all = points.to_vec();
    all.sort_unstable();
    all.dedup();
    let mut found = vec![all[0]];
    loop {
        let here = found[found.len() - 1];
        let far = |p: &Corner| (p.0 - here.0).pow(2) + (p.1 - here.1).pow(2);
        let others = all.iter().filter(|p| **p != here);
        let next = others.copied().reduce(|a, b| match area(&[here, a, b]) {
            0 if far(&b) > far(&a) => b,
            turn if turn < 0 => b,
            _ => a,
        });
        match next {
            Some(next) if next != all[0] && found.len() <= all.len() => found.push(next),
            _ => return found,
        }
    }
}

/// Random convex shapes whose corners crowd at the border: what bakes as drawn bakes welded, each
/// shape stays convex, keeps its side, and moves by at most the tolerance twice.
#[test]
fn random_shapes_stay_sound() {
    let mut random = Random(99);
    let (mut moved, mut kept) = (0, 0);
    for case in 0..600 {
        let mut along = || {
            let at = [0, 0, 16_000, 16_000, random.below(16_000) as i64][random.below(5) as usize];
            random.off(at, 700)
        };
        let mut shape = || hull(&(0..6).map(|_| (along(), along())).collect::<Vec<_>>());
        let tiles = [shape(), shape()];
        if tiles.iter().any(|tile| area(tile).abs() < 1_000_000) {
            continue;
        }
        // Apart, so that each is an outline of its own.
        let text = map(&tiles, &[2, 0, 3, 0]).replace(",1,1,1,1<", ",0,0,0,0<");
        let (drawn, welded) = (ground(&text, Some(0)).unwrap(), ground(&text, None).unwrap());
        // A shape of the library has no outline.
        for outline in &welded.outlines {
            let points = &outline.points;
            assert!(is_convex(points) && area(points) != 0, "case {case}: {points:?}");
            for p in points {
                let near = |q: &&(i64, i64)| (p.0 - q.0).abs().max((p.1 - q.1).abs()) <= 2 * (1 << 14);
                assert!(drawn.outlines.iter().flat_map(|o| &o.points).any(|q| near(&q)), "case {case}: {p:?}");
            }
        }
        assert!(welded.outlines.len() <= drawn.outlines.len(), "case {case}");
        moved += usize::from(drawn.outlines != welded.outlines);
        kept += usize::from(drawn.outlines == welded.outlines);
    }
    assert!(moved > 300 && kept > 10, "{moved} {kept}");
}

/// Two tiles side by side, each with a random shape: all that bakes as drawn bakes welded.
#[test]
fn nothing_more_is_refused() {
    let mut random = Random(5);
    let mut baked = 0;
    for case in 0..200 {
        let mut along = || {
            let at = [0, 16_000, random.below(16_000) as i64][random.below(3) as usize];
            random.off(at, 300)
        };
        // Both ends of the chain are near one corner of its tile. The shapes are not convex, and
        // some cross themselves.
        let chain = [(); 2].map(|()| (along() % 400 - 200, along() % 400 - 200));
        let mut shape = || (0..5).map(|_| (along(), along())).collect::<Vec<_>>();
        let text = map(&[shape(), shape(), chain.to_vec()], &[1, 2, 3, 4, 2, 1]);
        let file = scratch("weld", "any.tmx", &text);
        let out = folder("weld").join("any.rs");
        let drawn = run("bake", &file, &format!("-o {} --weld 0", out.display()));
        let welded = run("bake", &file, &format!("-o {}", out.display()));
        baked += usize::from(drawn.status == 0);
        assert!(drawn.status != 0 || welded.status == 0, "case {case}: {} {text}", welded.err);
    }
    assert!(baked > 100, "{baked}");
}

#[test]
fn the_option() {
    let file = scratch("weld", "option.tmx", map(&[vec![(100, 3000), (16_000, 9000), (0, 16_000)]], &[1, 2, 1]));
    let beside = file.with_file_name("tilesat.toml");
    // One of an earlier run.
    let _ = std::fs::remove_file(&beside);
    for wrong in ["-1", "1.5", "much"] {
        let ran = run("lint", &file, &format!("--weld {wrong}"));
        assert!(ran.status == 2 && ran.err.contains("--weld needs"), "{ran:?}");
    }
    let note = |options: &str| run("lint", &file, options).out.lines().filter(|line| line.contains("welded")).count();
    assert_eq!(["", "--weld 0.1", "--weld 0.05", "--weld 0"].map(note), [1, 1, 0, 0]);
    // A project says it once for all levels.
    std::fs::write(&beside, "weld = \"0\"").unwrap();
    assert_eq!(["", "--weld 0.25"].map(note), [0, 1]);
    std::fs::write(&beside, "weld = \"x\"").unwrap();
    let ran = run("lint", &file, "");
    assert!(ran.status == 2 && ran.err.contains("tilesat.toml: weld: needs pixels from 0 to 1, got x"), "{ran:?}");
}

/// The corners of whole cells are where they should be, whatever their grid.
#[test]
fn corners_that_stay_are_not_counted() {
    let layer = |side: u32, cells: &str| {
        let (width, height) = (64 / side, 48 / side);
        format!(
            r#"{{"__type":"IntGrid","__identifier":"Solid{side}","__cWid":{width},"__cHei":{height},"__gridSize":{side},"layerDefUid":2,"intGridCsv":[{cells}]}}"#
        )
    };
    let small = ["0,".repeat(40), "1,".repeat(7), "1".to_owned()].concat();
    let text = format!(
        r#"{{"defs":{{"layers":[{{"uid":2}}]}},"levels":[{{"identifier":"One","layerInstances":[{},{}]}}]}}"#,
        layer(8, &small),
        layer(16, "0,0,0,0,0,1,1,0,1,1,1,1")
    );
    let ran = run("bake", scratch("weld", "grids.ldtk", text), "--json");
    assert!(ran.status == 0 && !ran.out.contains("welded"), "{ran:?}");
}
