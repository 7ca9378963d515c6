//! Rays against segment maps: every hit in order, against each piece of the boundary separately.

use crate::segments::{P, Piece, SCALE, Scene, cross, dot, gcd, sub};
use tilesat::{Inside, PathKind, RayHit, SegmentMap, world::RayRules};

/// A moment and the normals of the hits then.
#[derive(Debug)]
pub struct Moment {
    pub num: i128,
    pub den: i128,
    pub normals: Vec<P>,
}

/// Both faces of walls, the boundary, and the one-way faces.
pub fn faces(scene: &Scene) -> Vec<(Piece, PathKind)> {
    let mut out: Vec<_> = scene.boundary().into_iter().map(|p| (p, PathKind::Solid)).collect();
    for shape in &scene.shapes {
        for (a, b) in shape.edges() {
            match shape.kind {
                PathKind::Wall => out.extend([(Piece { a, b }, shape.kind), (Piece { a: b, b: a }, shape.kind)]),
                PathKind::OneWay => out.push((Piece { a, b }, shape.kind)),
                _ => {}
            }
        }
    }
    out
}

/// Whether both sides of the ray are solid just after its start.
pub fn goes_in(scene: &Scene, o: P, d: P) -> bool {
    let g = gcd(d.0, d.1);
    let d = (d.0 / g, d.1 / g);
    // Directions to the ends of the domain are long: up to 2^43 / 2^60 on either side.
    let k = (1 << 43) / d.0.abs().max(d.1.abs());
    let at = |s: i128| (o.0 * SCALE + d.0 * k - s * d.1.signum(), o.1 * SCALE + d.1 * k + s * d.0.signum());
    scene.winding(at(1)) > 0 && scene.winding(at(-1)) > 0
}

pub fn expected(scene: &Scene, faces: &[(Piece, PathKind)], o: P, d: P, one_way: bool) -> Vec<Moment> {
    let mut met: Vec<(i128, i128, P)> = Vec::new();
    let crosses = |f: &&(Piece, PathKind)| {
        let (e, m) = (sub(f.0.b, f.0.a), sub(o, f.0.a));
        f.1 == PathKind::Wall && cross(e, d) != 0 && cross(e, m) == 0 && 0 <= dot(e, m) && dot(e, m) <= dot(e, e)
    };
    let enters = d != (0, 0) && (faces.iter().any(|f| crosses(&f)) || goes_in(scene, o, d));
    for (piece, kind) in faces {
        if *kind == PathKind::OneWay && !one_way {
            continue;
        }
        let (e, m) = (sub(piece.b, piece.a), sub(o, piece.a));
        let normal = (e.1, -e.0);
        // (m + t d) . normal = 0
        let (den, num) = (-dot(d, normal), dot(m, normal));
        if den <= 0 || num < 0 || num > den || (num == 0 && *kind != PathKind::OneWay && !enters) {
            continue;
        }
        let along = dot(m, e) * den + dot(d, e) * num;
        if 0 <= along && along <= dot(e, e) * den {
            let g = gcd(normal.0, normal.1);
            met.push((num, den, (normal.0 / g, normal.1 / g)));
        }
    }
    met.sort_by(|a, b| (a.0 * b.1).cmp(&(b.0 * a.1)));
    let mut out: Vec<Moment> = Vec::new();
    for (num, den, n) in met {
        match out.last_mut() {
            Some(last) if last.num * den == num * last.den => last.normals.push(n),
            _ => out.push(Moment { num, den, normals: vec![n] }),
        }
    }
    out
}

/// More along x, then more opposed, then +x, then +y.
pub fn first(normals: &[P], d: P) -> P {
    let share = |n: &P| (n.0 * n.0, dot(*n, *n));
    *normals
        .iter()
        .max_by(|a, b| {
            let ((p, q), (r, s)) = (share(a), share(b));
            (p * s).cmp(&(r * q)).then((-dot(**a, d)).cmp(&-dot(**b, d))).then(a.cmp(b))
        })
        .unwrap()
}

pub fn check(scene: &Scene, map: &SegmentMap<'_>, faces: &[(Piece, PathKind)], o: P, d: P, rules: RayRules) -> usize {
    let (origin, motion) = (scene.vec2(o), tilesat::Vec2::from_raw(d.0 as i32, d.1 as i32));
    let case = || format!("{scene:?}\nfrom {o:?} by {d:?}, {rules:?}");
    let mut hits: Vec<RayHit> = map.cast_ray_all(origin, motion, rules).unwrap().collect();
    assert_eq!(map.cast_ray(origin, motion, rules).unwrap(), hits.first().copied(), "{}", case());
    let inside = rules.inside == Inside::Hit && scene.inside(o);
    assert_eq!(hits.first().is_some_and(|h| h.inside), inside, "{}", case());
    if inside {
        let hit = hits.remove(0);
        assert_eq!((hit.toi.raw(), hit.point), (0, origin), "{}", case());
    }
    let moments = expected(scene, faces, o, d, rules.one_way);
    assert_eq!(hits.len(), moments.len(), "{}\n{hits:#?}\n{moments:#?}", case());
    for (hit, at) in hits.iter().zip(&moments) {
        assert_eq!(i128::from(hit.toi.raw()), (at.num << 30) / at.den, "{}\n{hit:?} {at:?}", case());
        let axis = (i128::from(hit.axis.x), i128::from(hit.axis.y));
        assert_eq!(axis, first(&at.normals, d), "{}\n{hit:?} {at:?}", case());
        // Less than a raw unit off on each axis, and not behind the face.
        let p = sub(scene.local(hit.point), o);
        let off = (p.0 * at.den - d.0 * at.num, p.1 * at.den - d.1 * at.num);
        assert!(off.0.abs() < at.den && off.1.abs() < at.den && dot(off, axis) >= 0, "{}\n{hit:?}", case());
        assert!(!hit.inside && hit.source == 0);
    }
    hits.len()
}
