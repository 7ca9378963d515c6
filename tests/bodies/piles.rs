//! Scenes: piles. Columns keep their order and do not sink, on the floor and on lifts. Heaps in a
//! pit fall asleep. Units, y down.

use tilesat::broad::{Handle, SortSweep};
use tilesat::scene::{SceneBody, SceneTag, Shape, Sleep};
use tilesat::{Aabb, Circle, Fx, Ratio, Scene, Surface, TileKind, TileKinds, TileMap, Vec2};
use tilesat_judge::{Random, cases, frames};

const BODIES: usize = 64;
static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);

type Piles = Scene<SortSweep<BODIES, SceneTag>, BODIES>;

/// A pit of cells of 16 with this width and height. Its floor is at `16 * high`, its walls are at
/// 16 and `16 * (wide - 1)`.
fn pit(wide: usize, high: usize) -> String {
    let row = format!("#{}#\n", ".".repeat(wide - 2));
    row.repeat(high) + &"#".repeat(wide) + "\n"
}

fn raw(x: i32, y: i32, w: i32, h: i32) -> Aabb {
    Aabb::new(Vec2::from_raw(x, y), Vec2::from_raw(x + w, y + h)).unwrap()
}

fn down(raw: i32) -> Vec2 {
    Vec2::from_raw(0, raw)
}

fn rough() -> Surface {
    Surface::new(Ratio::ZERO, Ratio::ONE)
}

fn bounds(scene: &Piles, handle: Handle) -> (i32, i32) {
    let bounds = scene.body(handle).unwrap().shape.aabb();
    (bounds.min().raw().1, bounds.max().raw().1)
}

/// The fault of a column, from its lowest body up.
fn fault(scene: &Piles, column: &[Handle], floor: i32) -> Option<String> {
    let mut below = floor;
    for (layer, &handle) in column.iter().enumerate() {
        let (top, bottom) = bounds(scene, handle);
        if (bottom - below).abs() > 1 {
            return Some(format!(
                "layer {layer} ends at {} instead of {}",
                Fx::from_bits(bottom),
                Fx::from_bits(below)
            ));
        }
        below = top;
    }
    None
}

/// A number of boxes falls from a height, with gaps between. Returns the steps until it sleeps.
fn column(scene: &mut Piles, floor: i32, count: i32, size: i32, fall: i32, gap: i32) -> Vec<Handle> {
    (0..count)
        .map(|k| {
            let y = floor - fall - (k + 1) * size - k * gap;
            let key = (k * 7 % 11) as u32;
            scene.insert(&SceneBody::new(raw(40 << 16, y, 8 << 16, size), key)).unwrap()
        })
        .collect()
}

fn settle(scene: &mut Piles, map: &TileMap<'_>, gravity: Vec2, most: u32) -> Option<u32> {
    for step in 0..most {
        if scene.awake().is_empty() {
            return Some(step);
        }
        scene.step(map, gravity, |_| {}).unwrap();
    }
    None
}

#[test]
fn columns_that_fall_keep_their_order_and_do_not_sink() {
    let (rows, mut wrong, mut most) = (pit(8, 20), Vec::new(), 0);
    let map = TileMap::from_ascii(&rows, &KINDS).unwrap();
    for count in 2..=8 {
        for gravity in [3277, 6554, 16_384] {
            for fall in [10, 30, 100] {
                for gap in [0, 1, 5] {
                    let mut scene = Piles::new(SortSweep::new());
                    let column = column(&mut scene, 320 << 16, count, 8 << 16, fall << 16, gap << 16);
                    let steps = settle(&mut scene, &map, down(gravity), 3000);
                    most = most.max(steps.unwrap_or(3000));
                    let fault = fault(&scene, &column, 320 << 16);
                    if let Some(fault) = fault.or(steps.is_none().then(|| "awake".into())) {
                        wrong.push(format!("{count} boxes, g {gravity}, fall {fall}, gap {gap}: {fault}"));
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} of 189 columns\n{}", wrong.len(), wrong.join("\n"));
    println!("asleep after {most} steps at most");
}

#[test]
fn columns_that_stand_stay() {
    let (rows, mut wrong) = (pit(8, 20), Vec::new());
    let map = TileMap::from_ascii(&rows, &KINDS).unwrap();
    for count in 2..=10 {
        for gravity in [1, 655, 6554, 16_384, 65_536] {
            for size in [2 << 16, 200_001, 8 << 16, 700_003, 16 << 16] {
                let mut scene = Piles::new(SortSweep::new());
                let column = column(&mut scene, 320 << 16, count, size, 0, 0);
                let steps = settle(&mut scene, &map, down(gravity), 300);
                let fault = fault(&scene, &column, 320 << 16);
                if let Some(fault) = fault.or(steps.is_none().then(|| "awake".into())) {
                    wrong.push(format!("{count} boxes of {size}, g {gravity}: {fault}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} of 225 columns\n{}", wrong.len(), wrong.join("\n"));
}

/// The game places a lift after the step, with a column of crates with friction on it, far above
/// the level.
struct Lift {
    scene: Piles,
    platform: Handle,
    bounds: Aabb,
    crates: Vec<Handle>,
}

impl Lift {
    fn of(count: i32) -> Self {
        let mut scene = Scene::with_sleep(SortSweep::new(), Sleep::NEVER);
        let bounds = raw(1000 << 16, -2000 << 16, 40 << 16, 4 << 16);
        let lift = scene.insert(&SceneBody { surface: rough(), ..SceneBody::fixed(bounds, 99) }).unwrap();
        let crates = (0..count)
            .map(|k| {
                let at = raw((1016 << 16) + k * 1000, -(2008 + k * 8) * (1 << 16), 8 << 16, 8 << 16);
                scene.insert(&SceneBody { surface: rough(), ..SceneBody::new(at, k as u32) }).unwrap()
            })
            .collect();
        Self { scene, platform: lift, bounds, crates }
    }

    fn step(&mut self, map: &TileMap<'_>, velocity: Vec2) {
        self.scene.set_velocity(self.platform, velocity).unwrap();
        self.scene.step(map, down(6554), |_| {}).unwrap();
        self.bounds = self.bounds.translated(velocity).unwrap();
        self.scene.place(self.platform, self.bounds).unwrap();
    }

    /// The crates' positions, relative to the lift.
    fn seen(&self) -> Vec<Vec2> {
        let at = |handle: &Handle| self.scene.body(*handle).unwrap().shape.position() - self.bounds.min();
        self.crates.iter().map(at).collect()
    }
}

#[test]
fn a_pile_on_a_lift_is_the_pile_at_rest() {
    let rows = pit(4, 2);
    let map = TileMap::from_ascii(&rows, &KINDS).unwrap();
    let mut wrong = Vec::new();
    for count in [1, 2, 3, 5, 10] {
        for velocity in [(0, 0), (0, 32_768), (0, -32_768), (9999, 0), (-65_536, 20_000), (7, -100_000)] {
            let velocity = Vec2::from_raw(velocity.0, velocity.1);
            let mut lift = Lift::of(count);
            for handle in lift.crates.clone() {
                lift.scene.set_velocity(handle, velocity).unwrap();
            }
            let start = lift.seen();
            for frame in 0..300 {
                lift.step(&map, velocity);
                if lift.seen() != start {
                    wrong.push(format!("{count} crates at {velocity:?}, frame {frame}: {:?} {start:?}", lift.seen()));
                    break;
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} of 30\n{}", wrong.len(), wrong.join("\n"));
}

/// On the floor, and on lifts that move up, down and aside and turn round. None may sleep.
/// `TILESAT_FRAMES` makes it a soak.
#[test]
fn stacks_of_ten_rest_for_ten_thousand_frames() {
    let rows = pit(4, 2);
    let map = TileMap::from_ascii(&rows, &KINDS).unwrap();
    for (vx, vy) in [(0, 0), (0, 6553), (0, -9999), (500, 0)] {
        let mut lift = Lift::of(10);
        let start = lift.seen();
        for frame in 0..frames(10_000_u32) {
            // To the left and up for as long as to the right and down.
            let sign = if frame / 200 % 2 == 0 { 1 } else { -1 };
            lift.step(&map, Vec2::from_raw(sign * vx, sign * vy));
            for (layer, (is, was)) in (0..).zip(lift.seen().iter().zip(&start)) {
                // If the lift turns round faster than they fall, they leave it for some steps.
                let turns = vy != 0 && frame % 200 < 8;
                assert!(
                    turns || (is.y - was.y).to_bits().abs() <= layer + 1,
                    "{vx} {vy}, frame {frame}, layer {layer}"
                );
                assert!((is.x - was.x).abs() < 1, "{vx} {vy}, frame {frame}, layer {layer}");
            }
        }
    }
}

/// The ball touches the top crate. All crates below are awake in that step.
#[test]
fn piles_wake_as_a_whole() {
    let rows = pit(8, 20);
    let map = TileMap::from_ascii(&rows, &KINDS).unwrap();
    for count in 2..=10 {
        let mut scene = Piles::new(SortSweep::new());
        column(&mut scene, 320 << 16, count, 8 << 16, 0, 0);
        assert!(settle(&mut scene, &map, down(6554), 300).is_some());
        let top = (320 - 8 * count) << 16;
        let ball = Circle::new(Vec2::from_raw(44 << 16, top - (3 << 16)), Fx::from_num(3)).unwrap();
        scene.insert(&SceneBody::new(ball, 99)).unwrap();
        assert_eq!(scene.awake().len(), 2, "the ball, and what it was put on");
        let stepped = scene.step(&map, down(6554), |_| {}).unwrap();
        assert_eq!((i32::from(stepped.woken), scene.awake().len()), (count - 1, count as usize + 1));
    }
}

#[test]
fn heaps_do_not_depend_on_the_order_of_insertion() {
    let rows = pit(8, 16);
    let map = TileMap::from_ascii(&rows, &KINDS).unwrap();
    for case in 0..cases(8) {
        let mut r = Random::new(case);
        let bodies = heap(&mut r, 40, case % 2 == 0);
        let (mut one, mut other) = (Piles::new(SortSweep::new()), Piles::new(SortSweep::new()));
        for (body, last) in bodies.iter().zip(bodies.iter().rev()) {
            one.insert(body).unwrap();
            other.insert(last).unwrap();
        }
        let seen = |scene: &Piles| {
            let mut seen: Vec<SceneBody> = scene.bodies().map(|(_, body)| *body).collect();
            seen.sort_by_key(|body| body.key);
            seen
        };
        for step in 0..400 {
            one.step(&map, down(6554), |_| {}).unwrap();
            other.step(&map, down(6554), |_| {}).unwrap();
            assert_eq!(seen(&one), seen(&other), "case {case}, step {step}");
        }
    }
}

/// Accelerates sideways by a twentieth per frame to 1.
#[test]
fn a_lift_that_speeds_up_takes_its_crates_along() {
    let rows = pit(4, 2);
    let map = TileMap::from_ascii(&rows, &KINDS).unwrap();
    for count in [1, 3, 6] {
        let mut lift = Lift::of(count);
        let start = lift.seen();
        let mut deepest = 0;
        for frame in 0..300 {
            lift.step(&map, Vec2::from_raw((frame + 1).min(20) * 3277, 0));
            for (is, was) in lift.seen().iter().zip(&start) {
                deepest = deepest.max((is.y - was.y).to_bits());
            }
        }
        let apart = lift.seen().iter().zip(&start).map(|(is, was)| (is.x - was.x).to_num::<f64>()).fold(0.0, f64::min);
        assert!(deepest <= count, "{count} crates sink by {}", Fx::from_bits(deepest));
        assert!(apart > -8.0, "{count} crates are left behind by {apart}");
    }
}

fn heap(r: &mut Random, count: u32, balls: bool) -> Vec<SceneBody> {
    (0..count as i32)
        .map(|k| {
            let size = r.within(6 << 16, 12 << 16) as i32 & !1;
            let (x, y) = (18 + 14 * (k % 6), 230 - 13 * (k / 6));
            let (x, y) = ((x << 16) + r.below(1 << 16) as i32, y << 16);
            let shape: Shape = if balls || r.one_in(2) {
                Circle::new(Vec2::from_raw(x + size / 2, y + size / 2), Fx::from_bits(size / 2)).unwrap().into()
            } else {
                raw(x, y, size, size).into()
            };
            let surface = Surface::new(
                Ratio::percent(r.below(31) as u8).unwrap(),
                Ratio::percent(30 + r.below(61) as u8).unwrap(),
            );
            SceneBody { surface: surface.resting_below(Fx::from_num(0.5)), ..SceneBody::new(shape, k as u32) }
        })
        .collect()
}

/// The steps that heaps of this size may take.
fn bound(count: u32) -> u32 {
    500 + 20 * count
}

#[test]
fn heaps_in_a_pit_fall_asleep() {
    let rows = pit(8, 16);
    let map = TileMap::from_ascii(&rows, &KINDS).unwrap();
    let (mut wrong, mut runs) = (Vec::new(), 0);
    for (count, balls, runs_of) in [(20, true, 5), (20, false, 5), (40, true, 2), (40, false, 3), (60, false, 2)] {
        let mut worst = 0;
        for case in 0..runs_of * cases(12) {
            let mut r = Random::new(case + u64::from(count));
            let mut scene = Piles::new(SortSweep::new());
            for body in heap(&mut r, count, balls) {
                scene.insert(&body).unwrap();
            }
            runs += 1;
            match settle(&mut scene, &map, down(6554), bound(count)) {
                Some(steps) => worst = worst.max(steps),
                None => {
                    wrong.push(format!("{count} bodies, balls {balls}, case {case}: {} awake", scene.awake().len()));
                }
            }
        }
        println!("{count} bodies, balls {balls}: {worst} steps at most");
    }
    assert!(wrong.is_empty(), "{} of {runs} heaps\n{}", wrong.len(), wrong.join("\n"));
}
