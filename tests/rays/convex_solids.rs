//! Rays at lists of convex solids, and the points of their borders nearest to a point, by exact
//! numbers: each solid as the intersection of half-planes, or as a union of boxes and discs. Also
//! the order of hits that are less than a raw unit apart.

use num_bigint::BigInt;
use tilesat::world::{ConvexSolid, ConvexSolids, OneWay};
use tilesat::{Capsule, ConvexPolygon, Fx, Inside, Joined, RayHit, Solid, Solids, TileKinds, TileMap, Vec2};
use tilesat_judge::convex::shape::hull;
use tilesat_judge::oracle::{measure, sum::Sum};
use tilesat_judge::solids::{P, disc, raw, rect, shapes, vec2};
use tilesat_judge::{Random, cases};

type Convex = ConvexSolid<shapes::Any>;

/// Moments are compared to that many bits. Two that differ, differ by more: they are roots of
/// quadratic equations with coefficients of 180 bits.
const BITS: u32 = 1000;

fn wide(n: i128) -> BigInt {
    BigInt::from(n)
}

fn cross(a: P, b: P) -> i128 {
    i128::from(a.0) * i128::from(b.1) - i128::from(a.1) * i128::from(b.0)
}

fn dot(a: P, b: P) -> i128 {
    i128::from(a.0) * i128::from(b.0) + i128::from(a.1) * i128::from(b.1)
}

fn less(a: P, b: P) -> P {
    (a.0 - b.0, a.1 - b.1)
}

enum Meeting {
    Inside,
    Never,
    /// In parts of 2^-BITS of the motion.
    At(BigInt),
}

fn ratio((num, den): (i128, i128)) -> BigInt {
    (wide(num) << BITS) / wide(den)
}

/// A closed polygon, or with `open` its inside. A fraction is a numerator and a denominator.
fn polygon(corners: &[P], o: P, d: P, open: bool) -> Meeting {
    let (mut entry, mut exit) = (None::<(i128, i128)>, None::<(i128, i128)>);
    let (mut slides, mut inside) = (false, true);
    for i in 0..corners.len() {
        let (a, b) = (corners[i], corners[(i + 1) % corners.len()]);
        let (height, rise) = (cross(less(b, a), less(o, a)), cross(less(b, a), d));
        inside &= height > 0;
        if height < 0 && rise <= 0 {
            return Meeting::Never;
        }
        if height <= 0 && rise > 0 && entry.is_none_or(|(n, m)| -height * m > n * rise) {
            entry = Some((-height, rise));
        }
        if height >= 0 && rise < 0 && exit.is_none_or(|(n, m)| height * m < n * -rise) {
            exit = Some((height, -rise));
        }
        slides |= height == 0 && rise <= 0;
    }
    if inside {
        return Meeting::Inside;
    }
    let Some((num, den)) = entry else { return Meeting::Never };
    let left = exit.map_or(1, |(n, m)| (n * den - num * m).signum());
    // A closed one is met by its corners too, but only by a ray that comes from outside.
    let misses = if open || num == 0 { left <= 0 || slides } else { left < 0 };
    if misses || num > den { Meeting::Never } else { Meeting::At(ratio((num, den))) }
}

/// The inside of a disc.
fn ball(centre: P, radius: i64, o: P, d: P) -> Meeting {
    let m = less(o, centre);
    let (outside, ahead, square) = (dot(m, m) - i128::from(radius).pow(2), -dot(m, d), dot(d, d));
    if outside < 0 {
        return Meeting::Inside;
    }
    let rest = wide(ahead) * wide(ahead) - wide(square) * wide(outside);
    if ahead <= 0 || rest <= wide(0) {
        return Meeting::Never;
    }
    let at = ((wide(ahead) << BITS) - (rest << (2 * BITS)).sqrt()) / wide(square);
    if at > wide(1) << BITS { Meeting::Never } else { Meeting::At(at) }
}

/// What is round consists of discs around its corners, and of the boxes between them.
fn meeting(figure: &shapes::Figure, o: P, d: P) -> Meeting {
    let r = figure.radius;
    if r == 0 {
        return polygon(&hull(&figure.points), o, d, false);
    }
    let (xs, ys) = (figure.points.iter().map(|p| p.0), figure.points.iter().map(|p| p.1));
    let (lo, hi) = ((xs.clone().min().unwrap(), ys.clone().min().unwrap()), (xs.max().unwrap(), ys.max().unwrap()));
    let mut all: Vec<_> = figure.points.iter().map(|&c| ball(c, r, o, d)).collect();
    for (x, y) in [(r, 0), (0, r)] {
        let (lo, hi) = ((lo.0 - x, lo.1 - y), (hi.0 + x, hi.1 + y));
        if lo.0 < hi.0 && lo.1 < hi.1 {
            all.push(polygon(&[lo, (hi.0, lo.1), hi, (lo.0, hi.1)], o, d, true));
        }
    }
    if all.iter().any(|one| matches!(one, Meeting::Inside)) {
        return Meeting::Inside;
    }
    let first = all.into_iter().filter_map(|one| if let Meeting::At(at) = one { Some(at) } else { None }).min();
    first.map_or(Meeting::Never, Meeting::At)
}

fn same(a: &BigInt, b: &BigInt) -> bool {
    let apart = a - b;
    apart < wide(5) && apart > wide(-5)
}

/// One hit of the solid that it names, at an exact moment.
fn check(hit: &RayHit, figure: &shapes::Figure, at: &BigInt, o: P, d: P, case: &dyn Fn() -> String) {
    let toi: BigInt = wide(hit.toi.raw().into());
    let exact: BigInt = at >> (BITS - 30);
    let way = d.0.abs().max(d.1.abs());
    if figure.radius == 0 {
        assert!((exact.clone() - &toi) <= wide(1) && toi <= exact, "{exact} {}", case());
    } else {
        let slack: BigInt = ((exact.clone() - &toi) * wide(way.into())) >> 30;
        assert!(toi <= exact && slack <= wide(4), "early by {slack} {}", case());
    }
    let (p, axis) = (raw(hit.point), (i64::from(hit.axis.x), i64::from(hit.axis.y)));
    let place = |o: i64, d: i64| -> BigInt { wide(o.into()) + ((at * wide(d.into())) >> BITS) };
    for (p, exact) in [(p.0, place(o.0, d.0)), (p.1, place(o.1, d.1))] {
        let apart = wide(p.into()) - exact;
        assert!(apart <= wide(5) && apart >= wide(-5), "{apart} {}", case());
    }
    let point = shapes::Figure { points: vec![p], radius: 0 };
    assert!(!figure.meets(&point), "{}", case());
    if figure.radius == 0 {
        let corners = hull(&figure.points);
        let is_side = |i: usize| {
            let (a, b) = (corners[i], corners[(i + 1) % corners.len()]);
            let (e, out) = (less(b, a), (axis.0, axis.1));
            let (height, rise) = (-cross(e, less(o, a)), cross(e, d));
            dot(e, out) == 0 && cross(out, e) > 0 && rise > 0 && same(&ratio((height, rise)), at)
        };
        assert!((0..corners.len()).any(is_side), "{}", case());
    } else {
        let radial = figure.points.iter().any(|&c| less(p, c) == axis);
        assert!(radial || axis.0.abs() + axis.1.abs() == 1, "{}", case());
    }
}

/// All hits of a ray. Returns how many there were, and how many solids shared their moments.
fn judge(list: &[Convex], o: P, d: P, random: &mut Random) -> (usize, usize) {
    let (start, motion) = (vec2(o), vec2(d));
    let case = || format!("{o:?} by {d:?}\n{}", tilesat_judge::solids::shapes::show(list));
    let figures: Vec<_> = list.iter().map(|s| (s.key(), shapes::Figure::of(&s.shape()))).collect();
    let mut meetings: Vec<(BigInt, u16)> = Vec::new();
    let mut holders = Vec::new();
    for (key, figure) in &figures {
        match meeting(figure, o, d) {
            Meeting::Inside => holders.push(*key),
            Meeting::Never => {}
            Meeting::At(at) => meetings.push((at, *key)),
        }
    }
    meetings.sort();
    let count = meetings.len();
    let mut groups: Vec<(BigInt, Vec<u16>)> = Vec::new();
    for (at, key) in meetings {
        match groups.last_mut() {
            Some((last, keys)) if same(last, &at) => keys.push(key),
            _ => groups.push((at, vec![key])),
        }
    }
    let solids = ConvexSolids::new(list);
    let got: Vec<_> = solids.cast_ray_all(start, motion, Inside::Ignore).unwrap().collect();
    let shown = || format!("{got:?}\n{:?}\n{}", groups.iter().map(|g| &g.1).collect::<Vec<_>>(), case());
    assert_eq!(got.len(), groups.len(), "{}", shown());
    for (hit, (at, keys)) in got.iter().zip(&groups) {
        let key = Solids::key_of(hit.cell).unwrap();
        assert!(keys.contains(&key) && !hit.inside && !hit.one_way, "{key} {}", shown());
        let figure = &figures.iter().find(|f| f.0 == key).unwrap().1;
        check(hit, figure, at, o, d, &shown);
    }
    let first = solids.cast_ray(start, motion, Inside::Hit).unwrap();
    if let Some(least) = holders.iter().min() {
        let hit = first.unwrap();
        assert!(hit.inside && hit.toi.raw() == 0 && hit.point == start, "{}", shown());
        assert_eq!(Solids::key_of(hit.cell), Some(*least), "{}", shown());
    } else {
        assert_eq!(first, got.first().copied(), "{}", shown());
    }
    let seen = solids.line_of_sight(start, vec2((o.0 + d.0, o.1 + d.1))).unwrap();
    assert_eq!(seen, got.is_empty() && holders.is_empty(), "{}", shown());
    let mut other = list.to_vec();
    random.shuffle(&mut other);
    let again: Vec<_> = ConvexSolids::new(&other).cast_ray_all(start, motion, Inside::Ignore).unwrap().collect();
    assert_eq!(again, got, "shuffled {}", shown());
    let empty = TileMap::from_ascii(".", &TileKinds::EMPTY).unwrap();
    let joined = Joined::new(&empty, &solids).cast_ray(start, motion, Inside::Hit).unwrap();
    assert_eq!(joined, first.map(|hit| RayHit { source: 1, ..hit }), "joined {}", shown());
    (got.len(), count - got.len())
}

/// Shapes on a lattice of cells of one size.
fn shape(random: &mut Random, unit: i64) -> shapes::Any {
    let at = |random: &mut Random| {
        let one = |random: &mut Random| random.around(6) * unit + [0, 0, random.around(unit)][random.below(3) as usize];
        (one(random), one(random))
    };
    loop {
        let c = at(random);
        let size = |random: &mut Random, most: i64| (random.within(1, most) * unit, random.within(1, most) * unit);
        let (w, h) = size(random, 4);
        let any: shapes::Any = match random.below(5) {
            0 => rect(c, (c.0 + w, c.1 + h)).into(),
            1 => disc(c, random.within(1, 5) * unit).into(),
            2 => {
                let end = if random.one_in(2) { (c.0 + w, c.1) } else { (c.0, c.1 + h) };
                Capsule::new(vec2(c), vec2(end), Fx::from_bits((random.within(1, 3) * unit) as i32)).unwrap().into()
            }
            3 => {
                let r = Fx::from_bits((random.within(1, 3) * unit) as i32);
                let points = [c, (c.0 + w, c.1), (c.0 + w, c.1 + h), (c.0, c.1 + h)].map(vec2);
                ConvexPolygon::new(&points).unwrap().with_radius(r).unwrap().into()
            }
            _ => {
                let points: Vec<_> = (0..random.within(3, 6)).map(|_| vec2(at(random))).collect();
                let Ok(polygon) = ConvexPolygon::hull(&points) else { continue };
                polygon.into()
            }
        };
        if Convex::new(any, 0).is_ok() {
            return any;
        }
    }
}

/// From lattice points of a few units to half of the domain.
const UNITS: [i64; 4] = [2, 4096, 65_537, 1 << 24];

fn scene(random: &mut Random, unit: i64) -> Vec<Convex> {
    let mut list: Vec<Convex> = Vec::new();
    for key in 0..random.within(1, 5) {
        // Some of them twice, or beside themselves.
        let any = match list.last() {
            Some(last) if random.one_in(4) => {
                let by = (random.around(1) * 2 * unit, random.around(1) * 2 * unit);
                last.shape().translated(vec2(by)).unwrap()
            }
            _ => shape(random, unit),
        };
        list.push(Convex::new(any, (key * 7 % 10) as u16).unwrap());
    }
    list
}

#[test]
fn every_hit_in_order() {
    let mut random = Random::new(91);
    let (mut hits, mut ties, mut rays) = (0, 0, 0);
    for n in 0..cases(3_000) {
        let unit = UNITS[(n % 4) as usize];
        let list = scene(&mut random, unit);
        for _ in 0..12 {
            let mut end = || (random.around(9) * unit, random.around(9) * unit);
            let (o, e) = (end(), end());
            let e = [e, e, (o.0, e.1), (e.0, o.1)][random.below(4) as usize];
            let (some, shared) = judge(&list, o, less(e, o), &mut random);
            (hits, ties, rays) = (hits + some, ties + shared, rays + 1);
        }
    }
    println!("{rays} rays, {hits} hits, {ties} more at the same moment");
    assert!(hits > rays / 2 && ties * 100 > hits);
}

/// Two solids whose borders the ray meets within a raw unit.
#[test]
fn hits_that_are_nearly_at_once() {
    let mut random = Random::new(92);
    let mut hits = 0;
    for n in 0..cases(6_000) {
        let unit = UNITS[1 + (n % 3) as usize];
        let mut end = || (random.around(9 * unit), random.around(9 * unit));
        let (o, e) = (end(), end());
        let d = less(e, o);
        let first = Convex::new(shape(&mut random, unit), 1).unwrap();
        let Meeting::At(at) = meeting(&shapes::Figure::of(&first.shape()), o, d) else { continue };
        // The point, and one of a circle or of a box that has it on its border but for roundings.
        let place = |o: i64, d: i64| o + i64::try_from((&at * wide(d.into())) >> BITS).unwrap();
        let p = (place(o.0, d.0) + random.around(1), place(o.1, d.1) + random.around(1));
        let second: shapes::Any = if random.one_in(2) {
            let r = random.within(1, 4 * unit);
            let (x, y) = (r * [3, 5, 8, 0][random.below(4) as usize] / 17, r * 15 / 17);
            // A Pythagorean triple, or any direction against the motion.
            let m = if random.one_in(2) { (x, y) } else { (y, x) };
            let c = (p.0 + m.0 * d.0.signum(), p.1 + m.1 * d.1.signum());
            disc(c, (m.0 * m.0 + m.1 * m.1).isqrt().max(1)).into()
        } else {
            let (w, h) = (random.within(1, 3 * unit), random.within(1, 3 * unit));
            rect((p.0, p.1 - h), (p.0 + w * d.0.signum() + i64::from(d.0 == 0), p.1 + h)).into()
        };
        let Ok(second) = Convex::new(second, 2) else { continue };
        hits += judge(&[first, second], o, d, &mut random).0;
    }
    println!("{hits} hits");
    assert!(hits > 2000);
}

/// Boxes apart from each other are met as a list of plain ones.
#[test]
fn boxes_are_boxes() {
    let mut random = Random::new(93);
    let mut hits = 0;
    for _ in 0..cases(2_000) {
        let column = |k: i64, random: &mut Random| {
            let lo = (k * 10 * 4096, random.around(5) * 4096);
            rect(lo, (lo.0 + random.within(1, 9) * 4096, lo.1 + random.within(1, 9) * 4096))
        };
        let all: Vec<_> = (0..random.within(1, 4)).map(|k| column(k, &mut random)).collect();
        let plain: Vec<_> = all.iter().zip(0..).map(|(b, key)| Solid::new(*b, key).unwrap()).collect();
        let convex: Vec<_> = all.iter().zip(0..).map(|(b, key)| ConvexSolid::new(*b, key).unwrap()).collect();
        for _ in 0..20 {
            let o = vec2((random.within(-3, 45) * 4096, random.around(12) * 4096));
            let d = vec2((random.around(40) * 4096, random.around(20) * 4096));
            for inside in [Inside::Ignore, Inside::Hit] {
                let seen = |hit: RayHit| (hit.toi, hit.point, hit.axis, hit.cell, hit.inside);
                let one: Vec<_> = Solids::new(&plain).cast_ray_all(o, d, inside).unwrap().map(seen).collect();
                let two: Vec<_> = ConvexSolids::new(&convex).cast_ray_all(o, d, inside).unwrap().map(seen).collect();
                assert_eq!(one, two, "{o:?} by {d:?} {all:?}");
                hits += one.len();
            }
        }
    }
    assert!(hits > 1000);
}

/// The square distance from a point within a polygon to its border, rounded down to a length: to
/// the nearest side. From within a round one, to the same of its core, and the radius more.
fn exit(figure: &shapes::Figure, p: P) -> Option<i64> {
    let corners = hull(&figure.points);
    let (r, n) = (figure.radius, corners.len());
    let point = shapes::Figure { points: vec![p], radius: 0 };
    if !figure.meets(&point) {
        return None;
    }
    if r > 0 {
        // In integers where the core is a point.
        let [c] = corners[..] else { return None };
        let m = less(p, c);
        let square = (m.0 * m.0 + m.1 * m.1) as u64;
        return Some(r - (square.isqrt() + u64::from(square.isqrt().pow(2) < square)) as i64);
    }
    let far = |i: usize| measure::to_edge(less(corners[i], p), less(corners[(i + 1) % n], p));
    let floor = (0..n).map(|i| {
        let square = far(i);
        let (mut low, mut high) = (0, 1i64 << 31);
        while high - low > 1 {
            let middle = i64::midpoint(low, high);
            if square.root_minus(middle) >= 0 { low = middle } else { high = middle }
        }
        low
    });
    floor.min()
}

#[test]
fn nearest_points() {
    let mut random = Random::new(94);
    let (mut outside, mut inside, mut none) = (0, 0, 0);
    for n in 0..cases(3_000) {
        let unit = UNITS[(n % 4) as usize];
        let list = scene(&mut random, unit);
        let solids = ConvexSolids::new(&list);
        let figures: Vec<_> = list.iter().map(|s| shapes::Figure::of(&s.shape())).collect();
        for _ in 0..8 {
            let p = (random.around(9) * unit, random.around(9) * unit + random.around(1));
            let within = random.within(0, 8 * unit);
            let near = solids.closest_point(vec2(p), Fx::from_bits(within as i32), OneWay::Include).unwrap();
            let case = || format!("{p:?} within {within}: {near:?}\n{}", tilesat_judge::solids::shapes::show(&list));
            let about = |f: &shapes::Figure| {
                let points: Vec<_> = hull(&f.points).into_iter().map(|q| less(q, p)).collect();
                measure::Measure::of(&Sum::of_hull(&points, f.radius))
            };
            let is_in = figures.iter().any(|f| about(f).overlaps());
            if let Some(near) = &near {
                let d = i64::from(near.distance.to_bits());
                assert_eq!(near.inside, is_in, "{}", case());
                // The point is as far away, but for its rounding, and on a border.
                let m = less(raw(near.point), p);
                let squared = |way: i64| i128::from(way.max(0)).pow(2);
                assert!((squared(d - 2)..=squared(d + 2)).contains(&dot(m, m)), "{}", case());
                let q = shapes::Figure { points: vec![raw(near.point)], radius: 2 };
                let core = shapes::Figure { points: vec![raw(near.point)], radius: 0 };
                let on = |f: &shapes::Figure| f.meets(&q) && exit(f, core.points[0]).is_none_or(|depth| depth <= 2);
                assert!(figures.iter().any(on), "{}", case());
                let (x, y) = (i64::from(near.axis.x), i64::from(near.axis.y));
                assert!((x, y) != (0, 0), "{}", case());
            }
            if is_in {
                let exits: Vec<_> = figures.iter().filter(|f| about(f).overlaps()).map(|f| exit(f, p)).collect();
                let Some(least) = exits.iter().copied().collect::<Option<Vec<_>>>().and_then(|e| e.into_iter().min())
                else {
                    continue;
                };
                match &near {
                    Some(near) if list.len() == 1 => {
                        assert_eq!(i64::from(near.distance.to_bits()), least, "{}", case());
                        inside += 1;
                    }
                    // Another border may be nearer.
                    Some(near) => assert!(i64::from(near.distance.to_bits()) <= least, "{}", case()),
                    None => assert!(least >= within, "{}", case()),
                }
                continue;
            }
            if let Some(near) = &near {
                let d = i64::from(near.distance.to_bits());
                assert!(figures.iter().any(|f| about(f).distance_is(d)), "{}", case());
                let nearer = |f: &shapes::Figure| d > 0 && !about(f).touches() && !farther(&about(f), d);
                assert!(!figures.iter().any(nearer), "{}", case());
                outside += 1;
            } else {
                assert!(figures.iter().all(|f| farther(&about(f), within)), "{}", case());
                none += 1;
            }
        }
    }
    println!("{outside} outside, {inside} inside, {none} too far");
    assert!(outside > 1000 && inside > 100 && none > 500);
}

/// Whether the distance is at least `d`.
fn farther(measure: &measure::Measure, d: i64) -> bool {
    !measure.touches() && measure.square.root_minus(measure.radius + d) >= 0
}

#[test]
fn what_is_refused() {
    let list = [ConvexSolid::new(disc((0, 0), 100), 1).unwrap()];
    let solids = ConvexSolids::new(&list);
    let far = Vec2::from_ints(9000, 0);
    assert!(solids.cast_ray(far, Vec2::ZERO, Inside::Hit).is_err());
    assert!(solids.line_of_sight(Vec2::ZERO, far).is_err());
    assert!(solids.closest_point(far, Fx::ONE, OneWay::Ignore).is_err());
    assert!(solids.closest_point(Vec2::ZERO, -Fx::ONE, OneWay::Ignore).is_err());
}
