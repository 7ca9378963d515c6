//! The room that half-planes leave.

use super::{Axis, HalfPlane, Raw, RoomToMove};
use crate::world::{Cell, Feature, Geometry};

fn room(planes: &[(i32, i32, i32, i32)], wanted: (i32, i32)) -> RoomToMove {
    let mut room = RoomToMove::new(Raw { x: wanted.0, y: wanted.1 }, 1000);
    for (i, &(nx, ny, x, y)) in planes.iter().enumerate() {
        let geometry = Geometry::Vertex { p: crate::num::Vec2::ZERO, e_in: Axis::X, e_out: Axis::Y };
        let feature = Feature { geometry, cell: Cell::default(), index: 0, flags: 0, one_way: false, source: 0 };
        room.add(Some(i as u16), &feature, HalfPlane { normal: Axis::new(nx, ny), at: Raw { x, y } });
    }
    room
}

/// No lattice point within the bounds is nearer than the answer, but for its roundings.
#[test]
fn the_nearest_displacement() {
    let mut random = tilesat_judge::Random::new(71);
    let (mut some, mut none) = (0, 0);
    for _ in 0..tilesat_judge::cases(20_000) {
        let mut number = |most: i64| random.around(most) as i32;
        let wanted = (number(12), number(12));
        let planes: [_; 3] = core::array::from_fn(|_| (number(5), number(5), number(9), number(9)));
        let planes = planes.map(|(x, y, a, b)| if (x, y) == (0, 0) { (1, 0, a, b) } else { (x, y, a, b) });
        let holds = |x: i32, y: i32, slack: i32| {
            planes.iter().all(|&(nx, ny, a, b)| nx * (x - a) + ny * (y - b) >= slack * (nx.abs() + ny.abs()))
        };
        let nearest = |slack: i32| {
            let all = (-60..=60).flat_map(|x| (-60..=60).map(move |y| (x, y)));
            let far = |(x, y): (i32, i32)| (x - wanted.0).pow(2) + (y - wanted.1).pow(2);
            all.filter(|p| holds(p.0, p.1, slack)).map(far).min()
        };
        if let Some(d) = room(&planes, wanted).nearest() {
            assert!(holds(d.x, d.y, 0), "{planes:?}");
            let by = (d.x - wanted.0).pow(2) + (d.y - wanted.1).pow(2);
            // Not farther than the nearest point two raw inside, and its roundings.
            if let Some(far) = nearest(2) {
                // A raw unit across is more along two borders that are nearly parallel.
                let more = |(a, b): (usize, usize)| {
                    let ((ax, ay, ..), (bx, by, ..)) = (planes[a], planes[b]);
                    let sizes = f64::from((ax * ax + ay * ay) * (bx * bx + by * by)).sqrt();
                    sizes / f64::from((ax * by - ay * bx).abs()).max(0.1)
                };
                let most = [(0, 1), (0, 2), (1, 2)].map(more).into_iter().filter(|m| *m < 100.0).fold(1.0, f64::max);
                let root = f64::from(by).sqrt() - f64::from(far).sqrt();
                assert!(root < 3.0 * most, "{planes:?} {wanted:?} {d:?} {far}");
            }
            some += 1;
        } else {
            assert!(nearest(3).is_none_or(|far| far > 3000), "{planes:?} {wanted:?}");
            none += 1;
        }
    }
    assert!(tilesat_judge::enough(some > 1000 && none > 100), "{some} {none}");
}
