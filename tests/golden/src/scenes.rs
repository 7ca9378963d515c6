//! Scenes among square tiles: boxes and circles, and the same with capsules. A vector is a step.

use tilesat::broad::{BroadPhase, SortSweep};
use tilesat::scene::{BodyShape, SceneEvent, SceneTag, Shape, WithCapsules};
use tilesat::{
    Aabb, Blocks, Capsule, Circle, Fx, Ratio, Scene, SceneBody, Surface, TileKind, TileKinds, TileMap, Vec2,
};

use super::VECTORS;
use super::family::Run;
use super::random::{Random, UNIT};

const BODIES: usize = 12;
/// A pit with two ledges.
pub(crate) const ROWS: &str = "\
##########
#........#
#........#
#..##....#
#......#.#
#........#
##########
";
pub(crate) static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
pub(crate) const GRAVITY: Vec2 = Vec2::from_raw(0, UNIT / 10);

/// A corner at the top of the pit, and two even sides.
fn extent(r: &mut Random) -> (i32, i32, i32, i32) {
    let mut within = |from: i32, units: u32| from * UNIT + (r.below(units << 8) << 8 | r.below(256)) as i32;
    let (w, h) = (within(4, 8) & !1, within(4, 8) & !1);
    (within(17, 112), within(17, 18), w, h)
}

pub(crate) fn plain(r: &mut Random) -> Option<Shape> {
    let (x, y, w, h) = extent(r);
    if r.once_in(2) {
        let at = Vec2::from_raw(x + w / 2, y + w / 2);
        return Circle::new(at, Fx::from_bits(w / 2)).ok().map(Shape::Circle);
    }
    Aabb::new(Vec2::from_raw(x, y), Vec2::from_raw(x + w, y + h)).ok().map(Shape::Aabb)
}

fn capsules(r: &mut Random) -> Option<WithCapsules> {
    if r.once_in(3) {
        return plain(r).map(WithCapsules::from);
    }
    let (x, y, w, h) = extent(r);
    let radius = w.min(h) / 2;
    let (a, b) = (Vec2::from_raw(x + radius, y + radius), Vec2::from_raw(x + w - radius, y + h - radius));
    Capsule::new(a, b, Fx::from_bits(radius)).ok().map(WithCapsules::Capsule)
}

fn scene<S: BodyShape>(run: &mut Run<'_>, of: &'static str, draw: fn(&mut Random) -> Option<S>) {
    let Ok(level) = TileMap::<Blocks>::from_ascii(ROWS, &KINDS) else { return };
    let mut scene = Scene::<SortSweep<BODIES, SceneTag>, BODIES, 0, S>::new(SortSweep::new());
    run.family(of, VECTORS / 2, ["step", "scene_events"], |number, r, [step, events]| {
        // A body falls in, for one that leaves; others are thrown.
        if number % 8 == 0 {
            let oldest = scene.bodies().map(|(handle, body)| (body.key, handle)).min();
            if let Some((_, handle)) = oldest.filter(|_| number >= 8 * BODIES as u32) {
                step.add(scene.remove(handle).is_ok());
            }
            let surface = Ratio::percent(r.below(80) as u8).zip(Ratio::percent(r.below(101) as u8));
            let (Some(shape), Some((bounces, friction))) = (draw(r), surface) else { return };
            let surface = Surface::new(bounces, friction).resting_below(Fx::from_bits(UNIT / 2));
            let velocity = Vec2::from_raw(r.signed(18), r.signed(18));
            let body = SceneBody { surface, velocity, fast: r.once_in(4), ..SceneBody::of(shape, number) };
            step.add(scene.insert(&body).is_ok());
        } else {
            let one = scene.bodies().nth(r.below(BODIES as u32) as usize).map(|(handle, _)| handle);
            let by = if r.once_in(8) { (r.signed(22), r.signed(22)) } else { (r.signed(16), 0) };
            step.add(one.is_some_and(|handle| scene.push(handle, Vec2::from_raw(by.0, by.1)).is_ok()));
        }
        // In no order, so as a sum.
        let mut sum = 0_u32;
        let stepped = scene.step(&level, GRAVITY, |event| {
            let mut one = super::Hash::new();
            match event {
                SceneEvent::Touch { pair, contact } => {
                    one.add(pair);
                    one.add(contact.copied());
                }
                SceneEvent::Meet { pair, toi, axis, speed } => {
                    one.add(pair);
                    one.add(toi);
                    one.add((axis, speed));
                }
                SceneEvent::Level { body, hits, velocity, .. } => {
                    one.add(body);
                    hits.iter().for_each(|hit| one.add(*hit));
                    one.add(velocity);
                }
                SceneEvent::Held { body, .. } => one.add(Some(body)),
                _ => {}
            }
            sum = sum.wrapping_add(one.value());
        });
        events.add(sum);
        step.add(stepped.map(|stepped| [stepped.pairs, stepped.touching, stepped.overlapping]).ok());
        for (handle, body) in scene.bodies() {
            step.add(scene.near().bounds(handle).ok());
            step.add(body.velocity);
        }
    });
}

pub(crate) fn run(run: &mut Run<'_>) {
    scene(run, "boxes_and_circles", plain);
}

pub(crate) fn run_capsules(run: &mut Run<'_>) {
    scene(run, "scene_of_capsules", capsules);
}
