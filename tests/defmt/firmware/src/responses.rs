//! Responses: surfaces, energies, particles.

use crate::tell;
use tilesat::motion::response::{
    Acceleration, ByFlags, ByHit, Carry, Energy, Link, Masses, Particle, Quiet, RelaxError, Responses, Smooth, Speed,
    Stick, Surface, split,
};
use tilesat::{Axis, Fx, Ratio, Vec2};

pub(crate) fn tell_all() {
    let v = Vec2::from_ints(3, -4);
    tell(&Surface::new(Ratio::percent(50).unwrap(), Ratio::percent(20).unwrap()));
    tell(&Smooth);
    tell(&Responses::NONE.bouncing(2));
    tell(&ByFlags::<Smooth>::default());
    tell(&ByHit::<()>::default());
    tell(&Speed::of(v));
    tell(&Energy::of(Vec2::from_ints(0, 9), v, Vec2::from_ints(0, 1)));
    tell(&Masses::new(2, 3).unwrap());
    tell(&split(v, Axis::NEG_Y).unwrap());
    let gravity = Acceleration::new(Vec2::from_ints(0, 1), 7).unwrap();
    tell(&gravity);
    tell(&gravity.act(v, Carry::ZERO).1);

    let bob = Particle::moving(Vec2::from_ints(5, 6), Vec2::from_ints(1, 0));
    tell(&bob);
    tell(&Quiet::NOT.watch(&[bob], Fx::from_num(2)));
    let stick = Stick::new(Fx::lit("12.5")).unwrap();
    tell(&stick);
    tell(&Link { a: 0, b: 1, stick });
    tell(&RelaxError::NoPoint { link: 3 });
}
