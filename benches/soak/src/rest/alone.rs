//! Bodies that a mover or a walker moves, each alone.

use super::{Any, GRAVITY, NOOKS, ODD, PLAIN, SLOPE, TRIANGLE, Table, UP};
use super::{bodies, capsule, level, map, polygon, rough, turned};
use std::fmt::Debug;
use tilesat::motion::{Memo, Support, Walker};
use tilesat::world::{ConvexSolid, ConvexSolids, World};
use tilesat::{Body, Fx, Joined, Mover, Surface, Vec2};

/// A body and its velocity.
type State<B> = (B, Vec2);

pub fn run(table: &mut Table) {
    let slick = UP.with_surface(Surface::SLICK);
    let grip = UP.with_surface(rough());
    let steep = level(&SLOPE);
    let slope = map(&steep);
    // Over the middle of the slope.
    let standing = capsule((1024, 300), (1024, 420), 60);
    let lying = capsule((960, 400), (1080, 400), 60);
    let slanted = capsule((960, 440), (1080, 380), 60);
    both(table, "capsule, standing, slope of tiles", &slope, &grip, standing);
    both(table, "capsule, lying, slope of tiles", &slope, &grip, lying);
    both(table, "capsule, along it, slope of tiles", &slope, &grip, Any::from(slanted));
    walks(table, "capsule, standing, slope of tiles, walker", &slope, standing);
    both(table, "turned box, slope of tiles", &slope, &grip, turned((1000, 400), (90, 50), (3, -1)));
    both(table, "turned box, along it, slope of tiles", &slope, &grip, turned((1000, 400), (90, 50), (2, -1)));
    walks(table, "turned box, slope of tiles, walker", &slope, turned((1000, 400), (90, 50), (5, 3)));
    both(table, "polygon, slope of tiles", &slope, &grip, polygon((1000, 400), &ODD));

    // The same on a slope of a convex solid: 7 to the side, 3 up.
    let open = level(&["........"; 8]);
    let open = map(&open).with_outside(tilesat::Outside::Empty);
    let wedge = polygon((1000, 1000), &[(-1400, 600), (1400, -600), (1400, 900), (-1400, 900)]);
    let wedges = [ConvexSolid::new(Any::from(wedge), 1).expect("small")];
    let solids = ConvexSolids::new(&wedges);
    let wedge = Joined::new(&open, &solids);
    both(table, "capsule, standing, convex slope", &wedge, &grip, capsule((1024, 300), (1024, 420), 60));
    both(table, "capsule, slanted, convex slope", &wedge, &grip, Any::from(capsule((960, 440), (1080, 380), 60)));
    walks(table, "capsule, lying, convex slope, walker", &wedge, lying);
    both(table, "turned box, convex slope", &wedge, &grip, turned((1000, 400), (90, 50), (4, 3)));
    both(table, "turned box, along it, convex slope", &wedge, &grip, turned((1000, 400), (90, 50), (7, -3)));
    both(table, "polygon, convex slope", &wedge, &grip, Any::from(polygon((1000, 400), &TRIANGLE)));

    for (name, rows, y) in NOOKS {
        let drawn = level(rows);
        let nook = map(&drawn);
        for (what, body) in bodies((768, y)) {
            both(table, &format!("{what}, {name}"), &nook, &slick, body);
        }
        both(table, &format!("turned box, its own type, {name}"), &nook, &slick, turned((768, y), (70, 60), (-1, 7)));
    }
}

fn both<W: World, B: Body + Copy + PartialEq + Debug>(
    table: &mut Table,
    name: &str,
    world: &W,
    mover: &Mover<Surface>,
    body: B,
) {
    let start: State<B> = (body, Vec2::ZERO);
    table.row(name, PLAIN, start, |(body, v)| {
        let moved = mover.move_and_slide(world, body, *v + GRAVITY).expect("it starts free");
        (*body, *v) = (moved.body, moved.velocity);
    });
    let mut memo = Memo::new();
    table.row(name, "memo", start, |(body, v)| {
        let moved = memo.move_and_slide(mover, world, 0, body, *v + GRAVITY).expect("it starts free");
        (*body, *v) = (moved.body, moved.velocity);
    });
}

/// A walker without a wish to go, on a slick surface.
fn walks<W: World, B: Body + Copy + PartialEq + Debug>(table: &mut Table, name: &str, world: &W, body: B) {
    let start: (State<B>, Option<Support>) = ((body, Vec2::ZERO), None);
    table.row(name, PLAIN, start, |((body, v), floor)| {
        let fall = Vec2::new(Fx::ZERO, v.y) + GRAVITY;
        let walked = Walker::new(UP).walk(world, body, fall, *floor).expect("it starts free");
        (*body, *v, *floor) = (walked.moved.body, walked.moved.velocity, walked.floor);
    });
}
