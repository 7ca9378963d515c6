//! Rays against a list of solids equal rays against the level of tiles with the same full cells:
//! every hit, in order, with one-way boxes, from inside and from borders. Also joined with tiles
//! that contain a part of them.

use tilesat::{
    AllShapes, Axis, Fx, Grid, Inside, Joined, Path, PathKind, RayHit, Side, Solid, Solids, TileKind, TileKinds,
    TileMap, TileShape, Toi, Vec2, segment_map, world::RayRules,
};
use tilesat_judge::solids::{P, raw, rect, show, solid, vec2};
use tilesat_judge::{Random, cases};

static KINDS: TileKinds = TileKinds::EMPTY
    .with(1, TileKind::FULL)
    .with(2, TileKind::ONE_WAY_UP)
    .with(3, TileKind::of(TileShape::OneWayRight))
    .with(4, TileKind::of(TileShape::OneWayDown))
    .with(5, TileKind::of(TileShape::OneWayLeft));
const SIDES: [Side; 4] = [Side::Up, Side::Right, Side::Down, Side::Left];
const SIDE: i64 = 5;
const CELL: i64 = 1 << 10;
const RULES: [RayRules; 4] = [
    RayRules { inside: Inside::Ignore, one_way: false },
    RayRules { inside: Inside::Hit, one_way: false },
    RayRules { inside: Inside::Ignore, one_way: true },
    RayRules { inside: Inside::Hit, one_way: true },
];

#[derive(Default)]
struct Scene {
    boxes: Vec<Solid>,
    union: [u8; 25],
    /// A part of the union, as tiles. `rest` is a part of the boxes that covers the remainder.
    part: [u8; 25],
    rest: Vec<Solid>,
}

fn scene(random: &mut Random) -> Scene {
    let mut s = Scene::default();
    for key in 0..random.within(1, 7) {
        let (x, y) = (random.below(SIDE), random.below(SIDE));
        let (w, h) = (random.within(1, (SIDE - x).min(3)), random.within(1, (SIDE - y).min(3)));
        let one = solid((x * CELL, y * CELL), ((x + w) * CELL, (y + h) * CELL), (key * 9000) as u16);
        if random.one_in(3) {
            // A one-way box is a row of tiles on the side that blocks.
            let k = random.below(4);
            let (xs, ys) = [
                (x..x + w, y..y + 1),
                (x + w - 1..x + w, y..y + h),
                (x..x + w, y + h - 1..y + h),
                (x..x + 1, y..y + h),
            ][k as usize]
                .clone();
            let cells: Vec<usize> = ys.flat_map(|j| xs.clone().map(move |i| (j * SIDE + i) as usize)).collect();
            // The level of tiles would not have it where it lay in a full tile.
            if cells.iter().any(|&c| s.union[c] > 0) {
                continue;
            }
            for c in cells {
                s.union[c] = 2 + k as u8;
            }
            let one = one.with_one_way(SIDES[k as usize]);
            s.boxes.push(one);
            s.rest.push(one);
            continue;
        }
        let cells: Vec<usize> = (y..y + h).flat_map(|j| (x..x + w).map(move |i| (j * SIDE + i) as usize)).collect();
        if cells.iter().any(|&c| s.union[c] > 1) {
            continue;
        }
        s.boxes.push(one);
        let tiles = random.one_in(2);
        if !tiles || random.one_in(4) {
            s.rest.push(one);
        }
        for c in cells {
            s.union[c] = 1;
            if tiles {
                s.part[c] = 1;
            }
        }
    }
    s
}

/// On the lattice of half cells, a unit beside it, or anywhere.
fn place(random: &mut Random) -> P {
    let one = |random: &mut Random| {
        let at = random.within(-1, 2 * SIDE + 1) * CELL / 2;
        at + [0, 0, random.around(1), random.around(CELL)][random.below(4) as usize]
    };
    (one(random), one(random))
}

/// For a solid and a one-way face at one moment, it may be either.
type Seen = (Toi, Vec2, Axis, bool);

fn seen(hit: RayHit) -> Seen {
    (hit.toi, hit.point, hit.axis, hit.inside)
}

/// The box that a hit names has that face there, or contains the start.
fn named(list: &[Solid], hit: &RayHit, case: &str) {
    let holder = list.iter().find(|s| Some(s.key()) == Solids::key_of(hit.cell)).unwrap();
    let (lo, hi, p) = (raw(holder.shape().min()), raw(holder.shape().max()), raw(hit.point));
    let near = |v: i64, lo: i64, hi: i64| lo - 1 <= v && v <= hi + 1;
    let at = match (hit.inside, hit.axis.x, hit.axis.y) {
        (true, ..) => lo.0 <= p.0 && p.0 <= hi.0 && lo.1 <= p.1 && p.1 <= hi.1,
        (_, 1, 0) => p.0 == hi.0 && near(p.1, lo.1, hi.1),
        (_, -1, 0) => p.0 == lo.0 && near(p.1, lo.1, hi.1),
        (_, 0, 1) => p.1 == hi.1 && near(p.0, lo.0, hi.0),
        (_, 0, -1) => p.1 == lo.1 && near(p.0, lo.0, hi.0),
        _ => false,
    };
    assert!(at && hit.source == 0 && hit.one_way == holder.one_way().is_some(), "{hit:?}\n{case}");
}

fn map(tiles: &[u8]) -> TileMap<'_, AllShapes> {
    let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_bits(CELL as i32), Vec2::ZERO).unwrap();
    TileMap::<AllShapes>::of(tiles, grid, &KINDS).unwrap()
}

/// All hits by all rules of one ray. Returns how many there were.
fn alone(s: &Scene, union: &TileMap<'_, AllShapes>, o: P, e: P) -> usize {
    let (start, motion) = (vec2(o), vec2((e.0 - o.0, e.1 - o.1)));
    let boxes = Solids::new(&s.boxes);
    let mut hits = 0;
    for rules in RULES {
        let case = || format!("{}{:?}\n{o:?} to {e:?} {rules:?}", show(&s.boxes), s.union);
        let got: Vec<_> = boxes.cast_ray_all(start, motion, rules).unwrap().collect();
        let expected: Vec<_> = union.cast_ray_all(start, motion, rules).unwrap().map(seen).collect();
        assert_eq!(got.iter().copied().map(seen).collect::<Vec<_>>(), expected, "{}", case());
        assert_eq!(boxes.cast_ray(start, motion, rules).unwrap(), got.first().copied(), "{}", case());
        for hit in &got {
            named(&s.boxes, hit, &case());
        }
        hits += got.len();
    }
    assert_eq!(boxes.line_of_sight(start, vec2(e)), union.line_of_sight(start, vec2(e)));
    hits
}

#[test]
fn rays_see_the_union_of_the_boxes() {
    let mut random = Random::new(71);
    let (mut hits, mut rays) = (0, 0);
    for _ in 0..cases(3_000) {
        let s = scene(&mut random);
        let union = map(&s.union);
        for _ in 0..20 {
            let (o, e) = (place(&mut random), place(&mut random));
            let e = [e, e, (o.0, e.1), (e.0, o.1)][random.below(4) as usize];
            hits += alone(&s, &union, o, e) + alone(&s, &union, e, o);
            rays += 2;
        }
    }
    println!("{rays} rays, {hits} hits");
    assert!(hits > rays);
}

/// From every point of the lattice of half cells in and around some boxes, toward a third of them,
/// in both directions.
#[test]
fn all_rays_of_a_lattice() {
    let half = CELL / 2;
    let mut hits = 0;
    for n in 0..cases(8) {
        let mut random = Random::new(500 + n);
        let s = scene(&mut random);
        let union = map(&s.union);
        let points: Vec<P> = (-1..=11).flat_map(|y| (-1..=11).map(move |x| (x * half, y * half))).collect();
        for &o in &points {
            for &e in points.iter().skip((o.0 + o.1).rem_euclid(3) as usize).step_by(3) {
                hits += alone(&s, &union, o, e);
            }
        }
    }
    assert!(hits > 1000);
}

#[test]
fn the_list_s_order_changes_no_hit() {
    let mut random = Random::new(72);
    for _ in 0..cases(2_000) {
        let mut s = scene(&mut random);
        let (o, e) = (place(&mut random), place(&mut random));
        let cast = |list: &[Solid], rules: RayRules| {
            let hits = Solids::new(list).cast_ray_all(vec2(o), vec2((e.0 - o.0, e.1 - o.1)), rules).unwrap();
            hits.collect::<Vec<_>>()
        };
        let before = RULES.map(|rules| cast(&s.boxes, rules));
        random.shuffle(&mut s.boxes);
        assert_eq!(RULES.map(|rules| cast(&s.boxes, rules)), before);
    }
}

#[test]
fn rays_see_the_union_of_tiles_and_boxes() {
    let mut random = Random::new(73);
    let (mut hits, mut rays) = (0u64, 0u64);
    for _ in 0..cases(4_000) {
        let s = scene(&mut random);
        let (union, part) = (map(&s.union), map(&s.part));
        let rest = Solids::new(&s.rest);
        let (one, other) = (Joined::new(&part, &rest), Joined::new(&rest, &part));
        for _ in 0..16 {
            let (o, e) = (place(&mut random), place(&mut random));
            let e = [e, e, (o.0, e.1), (e.0, o.1)][random.below(4) as usize];
            if union.touches(&rect(o, o)) {
                continue;
            }
            let (start, motion) = (vec2(o), vec2((e.0 - o.0, e.1 - o.1)));
            for rules in RULES {
                let case = || format!("{}{:?} {:?}\n{o:?} to {e:?} {rules:?}", show(&s.rest), s.part, s.union);
                let expected = union.cast_ray(start, motion, rules).unwrap();
                let (a, b) =
                    (one.cast_ray(start, motion, rules).unwrap(), other.cast_ray(start, motion, rules).unwrap());
                assert_eq!(a.map(seen), expected.map(seen), "{}", case());
                assert_eq!(b.map(seen), expected.map(seen), "{}", case());
                for (hit, of_box) in
                    [(a, 1), (b, 0)].map(|(hit, source)| (hit, hit.is_some_and(|h| h.source == source)))
                {
                    assert_eq!(hit.and_then(|h| Solids::key_of(h.cell)).is_some(), of_box, "{}", case());
                }
                if let Some(hit) = a.filter(|hit| hit.source == 1) {
                    named(&s.rest, &RayHit { source: 0, ..hit }, &case());
                }
                hits += u64::from(a.is_some());
                rays += 1;
            }
            assert_eq!(one.line_of_sight(start, vec2(e)), union.line_of_sight(start, vec2(e)));
        }
    }
    println!("{rays} rays, {hits} hit");
    assert!(hits > rays / 8);
}

#[test]
fn a_shot_at_a_lift_in_a_level_of_segments() {
    const FLOOR: [Vec2; 4] =
        [Vec2::from_ints(0, 64), Vec2::from_ints(128, 64), Vec2::from_ints(128, 80), Vec2::from_ints(0, 80)];
    segment_map!(static LEVEL: [Path::new(PathKind::Solid, &FLOOR)], Fx::lit("32"));
    let unit = 1 << 16;
    let mut lift = [solid((32 * unit, 40 * unit), (64 * unit, 48 * unit), 65_535).with_flags(6)];
    let down = |list: &[Solid], x: i16| {
        let here = Solids::new(list);
        let joined = Joined::new(&LEVEL, &here);
        joined.cast_ray(Vec2::from_ints(x, 0), Vec2::from_ints(0, 100), Inside::Hit).unwrap().unwrap()
    };
    let hit = down(&lift, 40);
    assert_eq!((hit.point, hit.axis, hit.source, hit.flags), (Vec2::from_ints(40, 40), Axis::NEG_Y, 1, 6));
    assert_eq!((hit.solid(), Solids::key_of(hit.cell)), (Some(65_535), Some(65_535)));
    assert_eq!(down(&lift, 8).solid(), None);
    // It has moved away after its motion.
    lift[0] = lift[0].with_motion(Vec2::from_ints(20, 0)).unwrap();
    Solid::move_all(&mut lift);
    assert_eq!((down(&lift, 40).point, down(&lift, 40).source), (Vec2::from_ints(40, 64), 0));
    assert_eq!(down(&lift, 84).point, Vec2::from_ints(84, 40));
    // Its edge blocks. A ray that slides along its side is not hit, nor is one that leaves it.
    let here = Solids::new(&lift);
    let slide = here.cast_ray(Vec2::from_ints(52, 44), Vec2::from_ints(0, 30), Inside::Hit).unwrap();
    assert_eq!(slide, None);
    assert!(here.cast_ray(Vec2::from_ints(52, 30), Vec2::from_ints(0, 30), Inside::Hit).unwrap().is_some());
    assert_eq!(here.cast_ray(Vec2::from_ints(60, 44), Vec2::from_ints(0, -30), Inside::Ignore), Ok(None));
    assert!(here.cast_ray(Vec2::from_ints(9000, 0), Vec2::ZERO, Inside::Hit).is_err());
}
