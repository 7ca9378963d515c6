//! Any broad phase as one type, so that the queries on all of them are compiled only once.

use tilesat::broad::{
    BroadError, BroadHit, BroadPhase, Handle, Nearest, Pair, PairCursor, PairsError, QueryError, Tag,
};
use tilesat::heapless::VecView;
use tilesat::{Aabb, Fx, RangeError, Toi, Vec2, error::Truncated};

/// A broad phase with its methods, each of which is one call of the same name.
pub struct Near<T>(Box<dyn Phase<T>>);

impl<T> Clone for Near<T> {
    fn clone(&self) -> Self {
        Self(self.0.copy())
    }
}

/// The refusal of a frame, and its body.
type Moved = Result<(), (Handle, BroadError)>;

impl<T: Tag + 'static> Near<T> {
    /// A broad phase that is asked only for bodies and pairs.
    pub fn new<P: BroadPhase<Tag = T> + Copy + 'static>(phase: P) -> Self {
        Self(Box::new(Plain(phase)))
    }

    /// A broad phase that also puts its pairs in order.
    pub fn paired<P: BroadPhase<Tag = T> + Copy + 'static>(phase: P) -> Self {
        Self(Box::new(Paired(phase)))
    }

    /// A broad phase with all queries. All answers of a structure together take most of the compile
    /// time.
    pub fn asked<P: BroadPhase<Tag = T> + Copy + 'static>(phase: P) -> Self {
        Self(Box::new(Asked(phase)))
    }

    pub fn insert(&mut self, bounds: &Aabb, tag: T) -> Result<Handle, BroadError> {
        self.0.phase_mut().insert(bounds, tag)
    }

    pub fn move_to(&mut self, handle: Handle, bounds: &Aabb) -> Result<(), BroadError> {
        self.0.phase_mut().move_to(handle, bounds)
    }

    pub fn move_each(&mut self, mut to: impl FnMut(Handle, &Aabb) -> Aabb) -> Moved {
        self.0.phase_mut().move_each(&mut to)
    }

    pub fn remove(&mut self, handle: Handle) -> Result<T, BroadError> {
        self.0.phase_mut().remove(handle)
    }

    pub fn contains(&self, handle: Handle) -> bool {
        self.0.phase().contains(handle)
    }

    pub fn bounds(&self, handle: Handle) -> Result<Aabb, BroadError> {
        self.0.phase().bounds(handle)
    }

    pub fn tag(&self, handle: Handle) -> Result<T, BroadError> {
        self.0.phase().tag(handle)
    }

    pub fn set_tag(&mut self, handle: Handle, tag: T) -> Result<(), BroadError> {
        self.0.phase_mut().set_tag(handle, tag)
    }

    pub fn len(&self) -> usize {
        self.0.phase().len()
    }

    pub fn is_empty(&self) -> bool {
        self.0.phase().is_empty()
    }

    pub fn bodies(&self) -> impl Iterator<Item = (Handle, Aabb, T)> + use<T> {
        self.0.list().into_iter()
    }

    pub fn pairs(&mut self, mut each: impl FnMut(Pair)) {
        self.0.phase_mut().pairs(&mut each);
    }

    pub fn pairs_from(
        &mut self,
        cursor: &mut PairCursor,
        budget: u32,
        out: &mut VecView<Pair>,
    ) -> Result<(), PairsError> {
        self.0.phase_mut().pairs_from(cursor, budget, out)
    }

    pub fn pairs_sorted(&mut self, out: &mut VecView<Pair>) -> Result<(), Truncated> {
        self.0.sorts().pairs_sorted(out)
    }

    pub fn pairs_of(&mut self, movers: &[Handle], mut each: impl FnMut(Pair)) -> Result<(), BroadError> {
        self.0.phase_mut().pairs_of(movers, &mut each)
    }

    pub fn in_region(&self, region: &Aabb, mut each: impl FnMut(Handle)) {
        self.0.phase().in_region(region, &mut each);
    }

    pub fn at_point(&self, point: Vec2, mut each: impl FnMut(Handle)) {
        self.0.phase().at_point(point, &mut each);
    }

    pub fn collect_region(&self, region: &Aabb, out: &mut VecView<Handle>) -> Result<(), Truncated> {
        self.0.asks().collect_region(region, out)
    }

    pub fn nearest(
        &self,
        point: Vec2,
        within: Fx,
        mut wanted: impl FnMut(Handle, &T) -> bool,
    ) -> Result<Option<Nearest>, RangeError> {
        self.0.asks().nearest(point, within, &mut wanted)
    }

    pub fn neighbours(
        &self,
        point: Vec2,
        within: Fx,
        mut wanted: impl FnMut(Handle, &T) -> bool,
        out: &mut VecView<Nearest>,
    ) -> Result<(), QueryError> {
        self.0.asks().neighbours(point, within, &mut wanted, out)
    }

    pub fn along(
        &self,
        start: &Aabb,
        motion: Vec2,
        mut each: impl FnMut(Handle, &T, Toi) -> Toi,
    ) -> Result<(), RangeError> {
        self.0.asks().along(start, motion, &mut each)
    }

    pub fn cast_ray(
        &self,
        origin: Vec2,
        motion: Vec2,
        mut wanted: impl FnMut(Handle, &T) -> bool,
        out: &mut VecView<BroadHit>,
    ) -> Result<(), QueryError> {
        self.0.asks().cast_ray(origin, motion, &mut wanted, out)
    }

    pub fn cast_shape(
        &self,
        start: &Aabb,
        motion: Vec2,
        mut wanted: impl FnMut(Handle, &T) -> bool,
        out: &mut VecView<BroadHit>,
    ) -> Result<(), QueryError> {
        self.0.asks().cast_shape(start, motion, &mut wanted, out)
    }
}

/// Writes a method list once, for an object and for the calls of the broad phase.
macro_rules! answers {
    ($trait:ident: $($name:ident($self:ident: $by:ty)($($arg:ident: $type:ty),*) $(-> $out:ty)?;)*) => {
        trait $trait<T> {
            $(fn $name($self: $by, $($arg: $type),*) $(-> $out)?;)*
        }

        impl<T: Tag, P: BroadPhase<Tag = T>> $trait<T> for P {
            $(fn $name($self: $by, $($arg: $type),*) $(-> $out)? {
                BroadPhase::$name($self, $($arg),*)
            })*
        }
    };
}

answers! {
    Bodies:
    insert(self: &mut Self)(bounds: &Aabb, tag: T) -> Result<Handle, BroadError>;
    move_to(self: &mut Self)(handle: Handle, bounds: &Aabb) -> Result<(), BroadError>;
    move_each(self: &mut Self)(to: &mut dyn FnMut(Handle, &Aabb) -> Aabb) -> Moved;
    remove(self: &mut Self)(handle: Handle) -> Result<T, BroadError>;
    contains(self: &Self)(handle: Handle) -> bool;
    bounds(self: &Self)(handle: Handle) -> Result<Aabb, BroadError>;
    tag(self: &Self)(handle: Handle) -> Result<T, BroadError>;
    set_tag(self: &mut Self)(handle: Handle, tag: T) -> Result<(), BroadError>;
    len(self: &Self)() -> usize;
    is_empty(self: &Self)() -> bool;
    pairs(self: &mut Self)(each: &mut dyn FnMut(Pair));
    pairs_from(self: &mut Self)(cursor: &mut PairCursor, budget: u32, out: &mut VecView<Pair>) -> Result<(), PairsError>;
    pairs_of(self: &mut Self)(movers: &[Handle], each: &mut dyn FnMut(Pair)) -> Result<(), BroadError>;
    in_region(self: &Self)(region: &Aabb, each: &mut dyn FnMut(Handle));
    at_point(self: &Self)(point: Vec2, each: &mut dyn FnMut(Handle));
}

answers! {
    Sorts:
    pairs_sorted(self: &mut Self)(out: &mut VecView<Pair>) -> Result<(), Truncated>;
}

answers! {
    Questions:
    collect_region(self: &Self)(region: &Aabb, out: &mut VecView<Handle>) -> Result<(), Truncated>;
    nearest(self: &Self)(point: Vec2, within: Fx, wanted: &mut dyn FnMut(Handle, &T) -> bool) -> Result<Option<Nearest>, RangeError>;
    neighbours(self: &Self)(point: Vec2, within: Fx, wanted: &mut dyn FnMut(Handle, &T) -> bool, out: &mut VecView<Nearest>) -> Result<(), QueryError>;
    along(self: &Self)(start: &Aabb, motion: Vec2, each: &mut dyn FnMut(Handle, &T, Toi) -> Toi) -> Result<(), RangeError>;
    cast_ray(self: &Self)(origin: Vec2, motion: Vec2, wanted: &mut dyn FnMut(Handle, &T) -> bool, out: &mut VecView<BroadHit>) -> Result<(), QueryError>;
    cast_shape(self: &Self)(start: &Aabb, motion: Vec2, wanted: &mut dyn FnMut(Handle, &T) -> bool, out: &mut VecView<BroadHit>) -> Result<(), QueryError>;
}

/// A structure whose answers to [`Sorts`] and [`Questions`] are compiled only if somebody uses
/// them.
trait Phase<T> {
    fn copy(&self) -> Box<dyn Phase<T>>;
    fn phase(&self) -> &dyn Bodies<T>;
    fn phase_mut(&mut self) -> &mut dyn Bodies<T>;
    fn list(&self) -> Vec<(Handle, Aabb, T)>;
    fn sorts(&mut self) -> &mut dyn Sorts<T>;
    fn asks(&self) -> &dyn Questions<T>;
}

macro_rules! phase {
    ($kind:ident, $self:ident => $sorts:expr, $asks:expr) => {
        struct $kind<P>(P);

        impl<T: Tag + 'static, P: BroadPhase<Tag = T> + Copy + 'static> Phase<T> for $kind<P> {
            fn copy(&self) -> Box<dyn Phase<T>> {
                Box::new(Self(self.0))
            }

            fn phase(&self) -> &dyn Bodies<T> {
                &self.0
            }

            fn phase_mut(&mut self) -> &mut dyn Bodies<T> {
                &mut self.0
            }

            fn list(&self) -> Vec<(Handle, Aabb, T)> {
                self.0.bodies().collect()
            }

            fn sorts(&mut $self) -> &mut dyn Sorts<T> {
                $sorts
            }

            fn asks(&$self) -> &dyn Questions<T> {
                $asks
            }
        }
    };
}

fn unasked() -> ! {
    panic!("`Near::asked`, or else `Near::paired`, makes a structure that answers this")
}

phase!(Plain, self => unasked(), unasked());
phase!(Paired, self => &mut self.0, unasked());
phase!(Asked, self => &mut self.0, &self.0);
