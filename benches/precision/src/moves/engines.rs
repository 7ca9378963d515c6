//! The character movers of engines, as their manuals use them. Their levels are convex pieces, one
//! static collider each.

use super::backends::fine;
use super::classes::{Case, FRAMES};
use super::pieces;
use super::room::Body;
use super::truth::Answer;
use crate::job::{Format, List};
use crate::peers::box2d::{length, vector};
use crate::peers::{RAPIER, box2d as box2d_peer};
use boxdd_sys::ffi::{
    b2Capsule, b2CollisionPlane, b2ComputeHull, b2CreateBody, b2CreatePolygonShape, b2CreateWorld, b2DefaultBodyDef,
    b2DefaultQueryFilter, b2DefaultShapeDef, b2DefaultWorldDef, b2MakePolygon, b2PlaneResult, b2ShapeId, b2SolvePlanes,
    b2Vec2, b2World_CastMover, b2World_CollideMover, b2World_RebuildStaticTree,
};
use rapier2d::control::{CharacterAutostep, CharacterLength, KinematicCharacterController};
use rapier2d::parry::query::DefaultQueryDispatcher;
use rapier2d::prelude::{
    Ball, BroadPhaseBvh, ColliderBuilder, ColliderSet, Cuboid, IntegrationParameters, Pose, QueryFilter, RigidBodySet,
    Shape, SharedShape, Vector,
};
use std::os::raw::c_void;
use tilesat_judge::oracle::figure::Figure;
use tilesat_judge::shapes::level::Level;

/// The world of its queries. It lives as long as the program.
struct World {
    bodies: RigidBodySet,
    colliders: ColliderSet,
    broad: BroadPhaseBvh,
}

fn rapier_world(level: &Level) -> &'static World {
    let mut world = World { bodies: RigidBodySet::new(), colliders: ColliderSet::new(), broad: BroadPhaseBvh::new() };
    for piece in pieces::all(level) {
        let corners: Vec<Vector> = piece.iter().map(|&(x, y)| Vector::new(x as f32, y as f32)).collect();
        let shape = SharedShape::convex_hull(&corners).expect("a piece has an area");
        world.colliders.insert(ColliderBuilder::new(shape));
    }
    let parameters = IntegrationParameters::default();
    let boxes: Vec<_> = world.colliders.iter().map(|(handle, c)| (handle, c.compute_aabb())).collect();
    boxes.into_iter().for_each(|(handle, bounds)| world.broad.set_aabb(&parameters, handle, bounds));
    Box::leak(Box::new(world))
}

/// A shape, its position, and its extent.
type Rapier = (Box<dyn Shape>, Vector, Vector);

/// It slides along every surface: nothing is too steep, and it never steps up or snaps.
pub fn rapier(list: &mut List<Case, Answer>, level: &'static Level) {
    const NO_STEP: Option<CharacterAutostep> = None;
    const NO_SNAP: Option<CharacterLength> = None;
    let world = rapier_world(level);
    let mover = KinematicCharacterController {
        up: Vector::NEG_Y,
        autostep: NO_STEP,
        snap_to_ground: NO_SNAP,
        max_slope_climb_angle: std::f32::consts::FRAC_PI_2,
        min_slope_slide_angle: 0.0,
        ..KinematicCharacterController::default()
    };
    let px = |(x, y): (i64, i64)| Vector::new((x as f64 / 65536.0) as f32, (y as f64 / 65536.0) as f32);
    list.add(
        (RAPIER, "move", Format::F32),
        move |c: &Case| {
            let body: Rapier = match c.start {
                Figure::Aabb { min, max } => {
                    let half = px((max.0 - min.0, max.1 - min.1)) / 2.0;
                    (Box::new(Cuboid::new(half)), px((min.0 + max.0, min.1 + max.1)) / 2.0, half)
                }
                Figure::Circle { centre, radius } => {
                    let r = (radius as f64 / 65536.0) as f32;
                    (Box::new(Ball::new(r)), px(centre), Vector::new(r, 0.0))
                }
                Figure::Segment { .. } => panic!("no such body"),
            };
            (body, c.motions.map(px))
        },
        move |((shape, start, reach), motions)| {
            let pipeline = world.broad.as_query_pipeline(
                &DefaultQueryDispatcher,
                &world.bodies,
                &world.colliders,
                QueryFilter::default(),
            );
            let mut at = *start;
            let ends = motions.map(|d| {
                let pose = Pose::from_translation(at);
                at += mover.move_shape(1.0 / 60.0, &pipeline, shape.as_ref(), &pose, d, |_| ()).translation;
                at
            });
            (ends, *reach)
        },
        |(ends, reach): &([Vector; FRAMES], Vector)| {
            ends.map(|at| {
                let (x, y) = (fine(at.x.into()), fine(at.y.into()));
                let (w, h) = (fine(reach.x.into()), fine(reach.y.into()));
                if h == 0 {
                    Body::Circle { c: (x, y), r: w }
                } else {
                    Body::Box { lo: (x - w, y - h), hi: (x + w, y + h) }
                }
            })
        },
    );
}

/// The planes for a mover.
struct Planes {
    planes: [b2CollisionPlane; 8],
    count: usize,
}

/// # Safety
/// `context` is the planes, which nobody else uses, and `result` is a valid plane.
unsafe extern "C" fn gather(_: b2ShapeId, result: *const b2PlaneResult, context: *mut c_void) -> bool {
    // SAFETY: as above.
    let (planes, result) = unsafe { (&mut *context.cast::<Planes>(), &*result) };
    if let Some(place) = planes.planes.get_mut(planes.count).filter(|_| result.hit) {
        *place = b2CollisionPlane { plane: result.plane, pushLimit: f32::MAX, push: 0.0, clipVelocity: true };
        planes.count += 1;
    }
    planes.count < planes.planes.len()
}

/// Its mover is a capsule. A circle is a capsule whose ends are one point. It has no boxes. The
/// loop is that of its sample.
pub fn box2d(list: &mut List<Case, Answer>, level: &'static Level) {
    const ROUNDS: usize = 5;
    const TOLERANCE: f32 = 0.01;
    // SAFETY: as in the library's manual. The world lives as long as the program.
    let (world, filter) = unsafe {
        let world = b2CreateWorld(&b2DefaultWorldDef());
        let body = b2CreateBody(world, &b2DefaultBodyDef());
        let def = b2DefaultShapeDef();
        for piece in pieces::all(level) {
            assert!(piece.len() <= 8, "its polygons have no more");
            let corners: Vec<b2Vec2> = piece.iter().map(|&(x, y)| b2Vec2 { x: x as f32, y: y as f32 }).collect();
            let hull = b2ComputeHull(corners.as_ptr(), corners.len() as i32);
            b2CreatePolygonShape(body, &def, &b2MakePolygon(&hull, 0.0));
        }
        b2World_RebuildStaticTree(world);
        (world, b2DefaultQueryFilter())
    };
    list.add(
        (box2d_peer::NAME, "move", Format::F32),
        |c: &Case| {
            let Figure::Circle { centre, radius } = c.start else { panic!("no mover for this") };
            (vector(centre), length(radius as f64), c.motions.map(vector))
        },
        move |&(start, radius, ref motions)| {
            let middle = b2Vec2 { x: 0.0, y: 0.0 };
            let capsule = b2Capsule { center1: middle, center2: middle, radius };
            let mut at = start;
            let ends = motions.map(|d| {
                let target = b2Vec2 { x: at.x + d.x, y: at.y + d.y };
                for _ in 0..ROUNDS {
                    // SAFETY: planes of zeros are valid planes, the world exists, and the callback
                    // gets the planes.
                    let step = unsafe {
                        let mut planes: Planes = std::mem::zeroed();
                        let context = (&raw mut planes).cast();
                        b2World_CollideMover(world, at, &capsule, filter, Some(gather), context);
                        let wanted = b2Vec2 { x: target.x - at.x, y: target.y - at.y };
                        let way = b2SolvePlanes(wanted, planes.planes.as_mut_ptr(), planes.count as i32).translation;
                        let part = b2World_CastMover(world, at, &capsule, way, filter);
                        b2Vec2 { x: way.x * part, y: way.y * part }
                    };
                    at = b2Vec2 { x: at.x + step.x, y: at.y + step.y };
                    if step.x * step.x + step.y * step.y < TOLERANCE * TOLERANCE {
                        break;
                    }
                }
                at
            });
            (ends, radius)
        },
        |(ends, radius): &([b2Vec2; FRAMES], f32)| {
            ends.map(|at| Body::Circle { c: (fine(at.x.into()), fine(at.y.into())), r: fine((*radius).into()) })
        },
    );
}
