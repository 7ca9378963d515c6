//! The single queries of other engines' tests, as facts. `theirs` has the result of their test if
//! it differs from ours, after the policy that explains it. Lengths are in raw units of 2^-16.

use tilesat_judge::oracle::figure::{Figure, Point};

const ONE: i64 = 1 << 16;

pub(crate) struct Pair {
    pub(crate) source: &'static str,
    pub(crate) theirs: &'static str,
    pub(crate) a: Figure,
    pub(crate) b: Figure,
}

pub(crate) struct Cast {
    pub(crate) source: &'static str,
    pub(crate) theirs: &'static str,
    pub(crate) a: Figure,
    pub(crate) b: Figure,
    pub(crate) d: Point,
}

pub(crate) struct Ray {
    pub(crate) source: &'static str,
    pub(crate) theirs: &'static str,
    pub(crate) shape: Figure,
    pub(crate) from: Point,
    pub(crate) d: Point,
}

/// In halves of a unit.
const fn half(x: i64, y: i64) -> Point {
    (x * ONE / 2, y * ONE / 2)
}

const fn at(x: i64, y: i64) -> Point {
    (x * ONE, y * ONE)
}

const fn rect(x0: i64, y0: i64, x1: i64, y1: i64) -> Figure {
    Figure::Aabb { min: at(x0, y0), max: at(x1, y1) }
}

/// A box from its corner and size, as in bump.
const fn sized(x: i64, y: i64, w: i64, h: i64) -> Figure {
    rect(x, y, x + w, y + h)
}

const fn disc(x: i64, y: i64, r: i64) -> Figure {
    Figure::Circle { centre: at(x, y), radius: r * ONE }
}

const fn line(a: Point, b: Point) -> Figure {
    Figure::Segment { a, b }
}

const fn raw(x: f64) -> i64 {
    (x * 65536.0 + if x < 0.0 { -0.5 } else { 0.5 }) as i64
}

pub(crate) fn rays() -> Vec<Ray> {
    let square = rect(-1, -1, 1, 1);
    let to = |source, theirs, shape, from: Point, to: Point| Ray {
        source,
        theirs,
        shape,
        from,
        d: (to.0 - from.0, to.1 - from.1),
    };
    let by = |source, theirs, shape, from, d| Ray { source, theirs, shape, from, d };
    let (down, wall) = (line(at(0, 1), at(0, -1)), line(at(0, -10), at(0, 10)));
    vec![
        to("box2d AABBRayCast 1", "", square, at(-3, 0), at(3, 0)),
        to("box2d AABBRayCast 2", "", square, at(3, 0), at(-3, 0)),
        to("box2d AABBRayCast 3", "", square, at(0, -3), at(0, 3)),
        to("box2d AABBRayCast 4", "", square, at(0, 3), at(0, -3)),
        to("box2d AABBRayCast 5", "", square, at(-3, 2), at(3, 2)),
        to("box2d AABBRayCast 6", "", square, at(2, -3), at(2, 3)),
        to("box2d AABBRayCast 7", "inside ignored: no hit", square, at(0, 0), at(3, 0)),
        to("box2d AABBRayCast 8", "", square, at(-2, -2), at(2, 2)),
        to("box2d AABBRayCast 9", "", square, half(-6, 3), half(6, 3)),
        to("box2d AABBRayCast 10", "", square, at(-2, 1), at(2, 1)),
        to("box2d AABBRayCast 11", "", square, at(-5, 0), at(-2, 0)),
        to("box2d AABBRayCast 12", "", square, at(-2, 0), at(-2, 0)),
        to("box2d AABBRayCast 13", "", square, at(-2, 0), at(-1, 0)),
        to("box2d AABBRayCast 14", "", rect(99, -51, 101, -49), at(97, -50), at(103, -50)),
        // Theirs is an endless ray: three times the motion has 4/3 as 4/9.
        by("impact-rs rect", "ray without an end: t 1.33332; exact 4/3", sized(5, 6, 7, 8), at(1, 2), at(9, 12)),
        by("parry issue_178_parallel_raycast", "", line(at(2, 1), at(2, 0)), at(0, 0), at(0, 4)),
        by("parry parallel_raycast", "", line(at(2, 1), at(2, -1)), at(0, 0), at(0, 4)),
        by("parry collinear, on it", "on a line along it: hit at 0", down, at(0, 0), at(0, 4)),
        by("parry collinear, before it", "", down, at(0, -2), at(0, 4)),
        by("parry collinear, pointing away", "", down, at(0, 2), at(0, 4)),
        by("parry perpendicular", "", wall, at(-1, 0), at(4, 0)),
        by("parry perpendicular, pointing away", "", wall, at(1, 0), at(4, 0)),
        by("parry perpendicular, on it", "", wall, at(0, 3), at(4, 0)),
        by("parry perpendicular, beyond the end", "", wall, at(0, 11), at(4, 0)),
        by("parry perpendicular, before the start", "", wall, at(0, -11), at(4, 0)),
        by("box2d RayCastShape circle", "", disc(1, 0, 1), at(-4, 0), at(8, 0)),
        by("box2d RayCastShape box", "", square, at(-4, 0), at(8, 0)),
        by("box2d RayCastShape segment", "", line(at(0, -1), at(0, 1)), at(-4, 0), at(8, 0)),
        by("box2d LargeWorldRayCast", "", rect(7000, -8000, 7001, -7999), at(6996, -8000), at(8, 0)),
        by("PixelRoot32 corner touch", "", rect(5, 5, 9, 9), at(0, 0), at(5, 5)),
        by(
            "bump querySegment along a border",
            "touching borders do not count",
            sized(0, 0, 64, 64),
            at(-8, 0),
            at(30, 0),
        ),
    ]
}

pub(crate) fn pairs() -> Vec<Pair> {
    let pair = |source, theirs, a, b| Pair { source, theirs, a, b };
    let (square, tenth) = (rect(-1, -1, 1, 1), ONE / 10);
    let unit = |x: i64, y: i64| Figure::Aabb { min: (x - ONE / 2, y - ONE / 2), max: (x + ONE / 2, y + ONE / 2) };
    let far = (8000 * ONE, -8000 * ONE);
    let ball = Figure::Circle { centre: (raw(0.051_793_8), raw(3.051_788_15)), radius: ONE / 2 };
    let point = |x, y| Figure::Circle { centre: half(x, y), radius: 0 };
    let two = sized(0, 0, 2, 2);
    let plank = |gap| Figure::Aabb { min: (gap, -raw(0.0016)), max: (gap + 2 * ONE, raw(0.0016)) };
    vec![
        pair("parry ball_cuboid test_false_negative", "", disc(1, 1, 1), square),
        pair("parry ball_cuboid_query_contact", "", ball, unit(0, 4 * ONE)),
        pair("parry ball_cuboid_query_contact, exchanged", "", unit(0, 4 * ONE), ball),
        pair("parry issue 31: a segment without length", "", line(at(3, 3), at(3, 3)), line(at(0, 0), at(9, 0))),
        pair("parry segments nearly touching", "", line(at(0, 0), at(4, 0)), line((2 * ONE, 1), at(2, 4))),
        pair(
            "parry segments touching",
            "closed: yes; ours overlap no, touch yes",
            line(at(0, 0), at(4, 0)),
            line(at(2, 0), at(2, 4)),
        ),
        pair("parry segments crossing", "", line(at(0, 0), at(4, 0)), line((2 * ONE, -1), at(2, 4))),
        pair("box2d PointInShape circle, in", "", disc(0, 0, 1), point(1, 1)),
        pair("box2d PointInShape box, in", "", square, point(1, 1)),
        pair("box2d PointInShape circle, out", "", disc(0, 0, 1), point(8, -8)),
        pair("box2d PointInShape box, out", "", square, point(8, -8)),
        pair("box2d SegmentDistance", "", line(at(-1, -1), at(-1, 1)), line(at(2, 0), at(1, 0))),
        pair("box2d ShapeDistance", "", rect(-1, -1, 1, 1), line(at(2, -1), at(2, 1))),
        pair("box2d ShapeDistanceShortEdge", "", point(0, 0), plank(raw(0.005))),
        pair("box2d LargeWorldManifold at the origin", "", unit(0, 0), unit(ONE - tenth, 0)),
        pair("box2d LargeWorldManifold far away", "", unit(far.0, far.1), unit(far.0 + ONE - tenth, far.1)),
        pair("bump rect_spec overlap", "ti -2 (the area), n(0,-1)", sized(0, 0, 7, 6), sized(5, 5, 1, 1)),
        pair("check2d separateBody, level line", "", sized(10, -10, 25, 25), line(at(0, 0), at(100, 0))),
        pair("check2d separateBody, diagonal line", "", sized(10, 5, 25, 25), line(at(0, 0), at(100, 100))),
        pair("agb rect touching", "closed in its documents, open in its code", sized(0, 0, 2, 2), sized(2, 0, 2, 2)),
        pair("agb rect overlapping", "", sized(0, 0, 2, 2), sized(1, 1, 2, 2)),
        pair("butano contains", "", two, point(2, 2)),
        pair("butano edge_contains", "closed by its name", two, point(0, 2)),
        pair("butano intersects", "", two, sized(1, 1, 2, 2)),
        pair("butano touches", "closed by its name", two, sized(2, 0, 2, 2)),
        pair("cute_c2 circles touching", "open: no", disc(0, 0, 3), disc(5, 0, 2)),
        pair("parry balls touching", "closed: bool yes, contact no", disc(0, 0, 5), disc(6, 8, 5)),
        pair(
            "box2d concentric circles",
            "normal (0,0): a hit that nothing can be pushed out of",
            disc(3, 3, 2),
            disc(3, 3, 5),
        ),
        pair(
            "torture 26: distance is the radius",
            "",
            Figure::Circle { centre: at(3, 4), radius: 5 * ONE },
            point(0, 0),
        ),
        pair(
            "torture 26: one raw unit less",
            "",
            Figure::Circle { centre: at(3, 4), radius: 5 * ONE - 1 },
            point(0, 0),
        ),
        pair(
            "torture 26: one raw unit more",
            "",
            Figure::Circle { centre: at(3, 4), radius: 5 * ONE + 1 },
            point(0, 0),
        ),
        pair(
            "torture 28: squares that wrap",
            "",
            Figure::Circle { centre: (0, 0), radius: 1 },
            Figure::Circle { centre: (46_341, 46_341), radius: 1 },
        ),
        pair(
            "torture 28: 181.02 units",
            "",
            disc(0, 0, 1),
            Figure::Circle { centre: (raw(181.02), raw(181.02)), radius: ONE },
        ),
    ]
}

pub(crate) fn casts() -> Vec<Cast> {
    let cast = |source, theirs, a, b, d| Cast { source, theirs, a, b, d };
    let point = |x, y| Figure::Segment { a: at(x, y), b: at(x, y) };
    vec![
        cast("bump rect_spec right", "", sized(1, 1, 1, 1), sized(5, 0, 1, 1), at(5, -1)),
        cast("bump rect_spec left", "", sized(6, 0, 1, 1), sized(1, 0, 1, 1), at(-5, 1)),
        cast("bump rect_spec down", "", sized(0, 0, 1, 1), sized(0, 4, 1, 1), at(0, 5)),
        cast("bump rect_spec up", "", sized(0, 4, 1, 1), sized(0, 0, 1, 1), at(0, -5)),
        cast("bump rect_spec nasty corner", "", sized(0, 16, 16, 16), sized(16, 0, 16, 16), at(-1, -1)),
        cast("bump World_spec project 1", "", sized(1, 1, 1, 1), sized(2, 0, 1, 3), at(10, 0)),
        cast("bump World_spec project 3", "", sized(1, 1, 1, 1), sized(5, 0, 1, 3), at(10, 0)),
        cast("bump World_spec project 5", "", sized(1, 1, 1, 1), sized(7, 0, 1, 3), at(10, 0)),
        cast("bump World_spec touching, then penetrating", "", sized(32, 50, 20, 20), sized(0, 50, 32, 20), at(-2, 0)),
        cast("bump responses_spec touch down", "", sized(10, 10, 2, 2), sized(0, 0, 8, 8), at(-9, -6)),
        cast("bump responses_spec touch right", "", sized(10, 10, 2, 2), sized(0, 0, 8, 8), at(-6, -9)),
        cast("bump responses_spec perfect corner", "n(1,0)", sized(10, 10, 2, 2), sized(0, 0, 8, 8), at(-9, -9)),
        cast(
            "bump responses_spec overlap with motion",
            "starts inside: pushed out against the motion",
            sized(3, 3, 2, 2),
            sized(0, 0, 8, 8),
            at(1, 2),
        ),
        cast("box2d ShapeCast", "f .5 within .005", rect(-1, -1, 1, 1), line(at(4, -1), at(4, 1)), at(6, 0)),
        cast("box2d TimeOfImpact", "", rect(-1, -1, 1, 1), line(at(2, -1), at(2, 1)), at(2, 0)),
        cast(
            "box2d LargeWorldRayCast, a ball",
            "",
            Figure::Circle { centre: at(6996, 0), radius: ONE / 4 },
            Figure::Aabb { min: (7000 * ONE - ONE / 2, -ONE / 2), max: (7000 * ONE + ONE / 2, ONE / 2) },
            at(8, 0),
        ),
        cast("PixelRoot32 circle through a rectangle", "", disc(-20, 5, 5), rect(0, 0, 10, 10), at(40, 0)),
        cast(
            "PixelRoot32 circle that starts inside",
            "start inside: t 0",
            disc(5, 5, 5),
            rect(0, 0, 10, 10),
            at(40, 0),
        ),
        cast(
            "PixelRoot32 segment to a corner",
            "closed: yes; a way that only touches starts no overlap",
            point(0, 0),
            rect(5, 5, 9, 9),
            at(5, 5),
        ),
        cast("impact-rs, to the surface exactly", "t < 1: none", sized(0, 0, 1, 1), sized(5, 0, 1, 1), at(4, 0)),
        cast("torture 6: outside corner", "square corners: .375", disc(0, 0, 5), rect(20, 3, 40, 30), at(40, 0)),
        cast(
            "torture 7: outside corner missed",
            "square corners: hit",
            Figure::Circle { centre: half(11, 51), radius: 5 * ONE },
            rect(20, 20, 40, 40),
            at(20, -20),
        ),
        cast("torture 9: vertex head on, left side", "", disc(16, 0, 8), line(at(16, 40), at(0, 48)), at(0, 64)),
        cast("torture 9: vertex head on, right side", "", disc(16, 0, 8), line(at(16, 40), at(32, 48)), at(0, 64)),
        cast("torture 10: corner onto a corner", "", sized(0, 0, 8, 8), sized(16, 16, 8, 8), at(16, 16)),
        cast("torture 20: one raw unit short", "", sized(0, 0, 1, 1), sized(5, 0, 1, 1), (4 * ONE - 1, 0)),
        cast("torture 20: one raw unit too far", "", sized(0, 0, 1, 1), sized(5, 0, 1, 1), (4 * ONE + 1, 0)),
    ]
}
