//! Velocities after responses.

use tilesat::motion::response::{Particle, Stick, bounce, exchange, respond, separate, slide, split};
use tilesat::prelude::*;
use tilesat::{
    Axis, Circle, Fx, Ratio, Surface, Vec2,
    motion::{Acceleration, Carry, Energy, Masses, Speed},
};

use super::VECTORS;
use super::family::Run;
use super::random::{Class, Direction, Random, pair};

/// A velocity: ordinary, of a few raw units, or as large as possible.
fn velocity(r: &mut Random, class: Class) -> Vec2 {
    let bits = match class {
        Class::Uniform | Class::Near => 18,
        Class::Lattice | Class::Touch => 2,
        Class::Far => 25,
        Class::Domain => 29,
    };
    Vec2::from_raw(r.signed(bits), r.signed(bits))
}

fn normal(r: &mut Random, class: Class) -> Axis {
    match class {
        Class::Uniform => Axis::new(r.small(3), r.small(3)),
        Class::Lattice | Class::Touch | Class::Near => {
            let d = Direction::any(r);
            Axis::new(d.x, d.y)
        }
        Class::Far => Axis::new(r.signed(20), r.signed(20)),
        Class::Domain => Axis::new(r.signed(29), r.signed(29)),
    }
}

fn ratio(r: &mut Random) -> Ratio {
    match r.below(4) {
        0 => Ratio::percent(0),
        1 => Ratio::percent(100),
        _ => Ratio::from_raw(r.word() >> 2),
    }
    .unwrap_or(Ratio::HALF)
}

pub(crate) fn run(run: &mut Run<'_>) {
    let queries = ["split", "slide", "bounce", "respond", "bounce_at", "resting", "energy", "exchange"];
    run.family(
        "velocities",
        VECTORS,
        queries,
        |number, r, [parts, slid, bounced, answered, fast, resting, energy, exchanged]| {
            let class = Class::of(number);
            let (v, n, restitution, friction) = (velocity(r, class), normal(r, class), ratio(r), ratio(r));
            parts.add(split(v, n).map(|parts| [parts.normal, parts.tangent]));
            slid.add(slide(v, n));
            bounced.add(bounce(v, n, restitution));
            answered.add(respond(v, n, restitution, friction));
            let surface = Surface::new(restitution, friction);
            let other = velocity(r, class);
            let speed = Speed::of(v).changed(v, other);
            fast.add(speed);
            fast.add(speed.bounce(v, n));
            resting.add(surface.resting_below(Fx::from_bits(r.signed(18).abs())).respond(v, n));
            resting.add(surface.with_speed(speed).respond(v, n));
            let (at, gravity) = (velocity(r, Class::Far), velocity(r, Class::Lattice));
            let of = Energy::of(at, v, gravity);
            energy.add(of.raw());
            energy.add(of.speed(other, v, gravity));
            let masses = Masses::new(r.word() as u8, r.word() as u8).unwrap_or(Masses::A_FIXED);
            exchanged.add([masses.share_of_a(), masses.swapped().share_of_a()]);
            exchanged.add(exchange(v, other, n, masses, &surface).map(|(a, b)| [a, b]));
        },
    );
    run.family(
        "positions",
        VECTORS,
        ["separate", "pull", "step", "accelerate"],
        |number, r, [apart, pulled, stepped, faster]| {
            let class = Class::of(number);
            let (a, b, v) = pair::<Circle, Circle>(r, class);
            let share = ratio(r);
            apart.add(a.contact(&b).map(|contact| separate(&contact, share)));
            let length = if r.once_in(2) { a.distance(&b) } else { a.radius() };
            for stick in [Stick::new(length), Stick::rope(length)] {
                pulled.add(stick.map(|stick| stick.with_share_of_a(share).pull(a.centre(), b.centre())));
            }
            let particle = Particle::moving(a.centre(), v).step(b.centre(), share);
            stepped.add([particle.position, particle.previous, particle.velocity()]);
            let Some(gravity) = Acceleration::new(b.centre(), r.below(999)) else { return faster.add(()) };
            let (mut velocity, mut carry) = (v, Carry::ZERO);
            for _ in 0..4 {
                (velocity, carry) = gravity.act(velocity, carry);
                carry = gravity.supported(velocity, carry);
                faster.add(velocity);
            }
        },
    );
}
