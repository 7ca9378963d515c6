//! Libraries that hold the solid cells in separate trees or tables.

use super::classes::Ray;
use super::level::{CELL, Level};
use super::truth::Answer;
use crate::job::{Format, List};
use crate::peers;
use std::ptr;
use std::rc::Rc;
use tilesat_judge::Random;

macro_rules! parry {
    ($module:ident, $parry:ident, $voxels:literal, $compound:literal) => {
        pub mod $module {
            use super::{Answer, CELL, Level, List, Ray, Rc};
            use crate::peers::parry::$module::{FORMAT, length, vector};
            use $parry::math::{IVector, Pose, Real, Vector};
            use $parry::query::{Ray as Line, RayCast, RayIntersection};
            use $parry::shape::{Compound, SharedShape, Voxels};

            fn add(list: &mut List<Ray, Answer>, name: &'static str, shape: impl RayCast + 'static) {
                let shape = Rc::new(shape);
                // The loops may live as long as the program, and so does their level.
                let shape: &'static _ = Box::leak(Box::new(shape));
                list.add(
                    (name, "ray", FORMAT),
                    |r: &Ray| Line::new(vector(r.o), vector(r.d)),
                    move |ray| shape.cast_local_ray_and_get_normal(ray, 1.0, true),
                    |hit: &Option<RayIntersection>| hit.map(|h| f64::from(h.time_of_impact)),
                );
            }

            /// A table of the solid cells.
            pub fn voxels(level: &Level) -> Voxels {
                let size: Real = length(CELL as f64);
                let cells: Vec<IVector> = level.solid_cells().map(|(x, y)| IVector::new(x as _, y as _)).collect();
                Voxels::new(Vector::new(size, size), &cells)
            }

            /// A tree with a box per solid cell.
            pub fn compound(level: &Level) -> Compound {
                let size: Real = length(CELL as f64);
                let boxes = level.solid_cells().map(|(x, y)| {
                    let middle = |v: i64| (v as Real + 0.5) * size;
                    (Pose::translation(middle(x), middle(y)), SharedShape::cuboid(size / 2.0, size / 2.0))
                });
                Compound::new(boxes.collect())
            }

            pub fn rays(list: &mut List<Ray, Answer>, level: &Rc<Level>) {
                add(list, $voxels, voxels(level));
                add(list, $compound, compound(level));
            }
        }
    };
}

parry!(single, parry2d, "parry2d Voxels", "parry2d Compound");
parry!(double, parry2d_f64, "parry2d-f64 Voxels", "parry2d-f64 Compound");

/// One static body with a box per cell.
pub fn box2d(list: &mut List<Ray, Answer>, level: &Rc<Level>) {
    use boxdd_sys::ffi::{
        b2CreateBody, b2CreatePolygonShape, b2CreateWorld, b2DefaultBodyDef, b2DefaultQueryFilter, b2DefaultShapeDef,
        b2DefaultWorldDef, b2MakeOffsetBox, b2Rot, b2World_CastRayClosest, b2World_RebuildStaticTree,
    };
    use peers::box2d::{NAME, vector};
    // SAFETY: as in the library's manual. The world lives as long as the program.
    let (world, filter) = unsafe {
        let world = b2CreateWorld(&b2DefaultWorldDef());
        let body = b2CreateBody(world, &b2DefaultBodyDef());
        let def = b2DefaultShapeDef();
        for (x, y) in level.solid_cells() {
            let middle = vector((x * CELL + CELL / 2, y * CELL + CELL / 2));
            let shape = b2MakeOffsetBox(8.0, 8.0, middle, b2Rot { c: 1.0, s: 0.0 });
            b2CreatePolygonShape(body, &def, &shape);
        }
        b2World_RebuildStaticTree(world);
        (world, b2DefaultQueryFilter())
    };
    list.add(
        (NAME, "ray", Format::F32),
        |r: &Ray| (vector(r.o), vector(r.d)),
        // SAFETY: the world exists.
        move |&(o, d)| unsafe { b2World_CastRayClosest(world, o, d, filter) },
        |hit| hit.hit.then(|| f64::from(hit.fraction)),
    );
}

/// One static box per cell, in any order: rows would make its tree worse.
pub fn chipmunk(list: &mut List<Ray, Answer>, level: &Rc<Level>) {
    use chipmunk_sys::{
        Struct_cpBB, Struct_cpShapeFilter, cpBoxShapeNew2, cpSegmentQueryInfo, cpSpaceAddShape, cpSpaceGetStaticBody,
        cpSpaceNew, cpSpaceSegmentQueryFirst, cpv,
    };
    use peers::chipmunk::{NAME, vector};
    let filter = Struct_cpShapeFilter { group: 0, categories: !0, mask: !0 };
    // SAFETY: as in the library's manual. The space lives as long as the program.
    let space = unsafe {
        let space = cpSpaceNew();
        let (mut cells, mut r) = (level.solid_cells().collect::<Vec<_>>(), Random::new(1));
        for i in (1..cells.len()).rev() {
            cells.swap(i, r.below(i as i64 + 1) as usize);
        }
        for (x, y) in cells {
            let (lo, hi) = (vector((x * CELL, y * CELL)), vector(((x + 1) * CELL, (y + 1) * CELL)));
            let bounds = Struct_cpBB { l: lo.x, b: lo.y, r: hi.x, t: hi.y };
            cpSpaceAddShape(space, cpBoxShapeNew2(cpSpaceGetStaticBody(space), bounds, 0.0));
        }
        space
    };
    list.add(
        (NAME, "ray", Format::F64),
        |r: &Ray| (vector(r.o), vector((r.o.0 + r.d.0, r.o.1 + r.d.1))),
        move |&(from, to)| {
            let nothing = cpv(0.0, 0.0);
            let mut info = cpSegmentQueryInfo { shape: ptr::null(), point: nothing, normal: nothing, alpha: 1.0 };
            // SAFETY: the space exists, and the answer's memory is valid.
            let shape = unsafe { cpSpaceSegmentQueryFirst(space, from, to, 0.0, filter, &mut info) };
            (!shape.is_null(), info.alpha)
        },
        |&(hit, t)| hit.then_some(t),
    );
}
