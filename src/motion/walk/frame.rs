//! One frame of a character that walks: on the ground, or in the air up to the first floor.

use super::ground::{Look, Support, leads};
use super::stride::{Footing, Stride};
use super::walker::Walker;
use crate::motion::order::First;
use crate::motion::plane::may_be_askew;
use crate::motion::run::Run;
use crate::motion::search::{Around, check_cells};
use crate::motion::{Body, MoveError, Moved};
use crate::num::{Fx, Raw, Vec2};
use crate::world::World;

/// Where a walker ended up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[must_use = "the body moves only if you keep `Walked::moved`"]
pub struct Walked<B> {
    /// The motion. On a floor its velocity is level (across "up"): the speed for the next frame. In
    /// the air it is the velocity at which it left the ground, less the part that hits took.
    ///
    /// Its `wall` is true if a wall still blocks after the last step: the sign to turn round. The
    /// face of a step is among its `hits` either way.
    pub moved: Moved<B>,
    /// The floor that it stands on. Pass it to the next call. For a round body on an edge it may be
    /// the floor ahead: see [`Walker::walk`].
    pub floor: Option<Support>,
    /// Whether it walked on a floor or landed on one in this frame. If [`floor`](Self::floor) is
    /// `None`, it has left that floor again: for example, it landed on the edge of a platform and
    /// slid off.
    pub met_floor: bool,
    /// How far it rose on steps, in units.
    pub stepped: Fx,
    /// How far it was pulled down to the ground, in units; 0 for mere rounding.
    pub snapped: Fx,
}

impl<B> Walked<B> {
    /// Whether it stands on a floor.
    #[must_use]
    pub const fn on_floor(&self) -> bool {
        self.floor.is_some()
    }
}

impl Walker {
    /// Walks or flies for one frame. `floor` is the one that the last call returned. Pass `None` at
    /// first, and after you moved the body elsewhere.
    ///
    /// **On a floor**, unless the velocity rises, the walking speed is the velocity across "up".
    /// The downward part does not count, so nothing slips. The body follows the floor up and down
    /// where it bends. At a wall, at ground steeper than the slope limit, and under a ceiling it
    /// stops, and its velocity is zero. If the ground falls away by more than the snap, it flies on
    /// with its velocity along the floor.
    ///
    /// **In the air** it moves as [`Mover::move_and_slide`] until it meets a floor, where it walks
    /// for the rest of the frame. One thing differs: walls, and so steep slopes, take the velocity
    /// against them across "up". Pushing therefore does not climb them. The mover's response
    /// applies there. A floor that neither carries the body nor lets it walk holds nothing up. The
    /// body falls past the foot of a ramp that a ceiling bars.
    ///
    /// The way of a frame is never longer than the velocity, except for steps, snapping, and up to
    /// 4 raw of rounding at joints. It is shorter by less than 2 raw on a slope of tiles, and by up
    /// to 10 around the joints of slopes. A circle goes around a corner by the tangents to its way.
    /// That costs up to a fifth of the frame's way once, and more if corners follow each other
    /// within a frame. Through a quarter pipe it moves by chords, and stops before the slope passes
    /// the limit. Mirrored scenes give mirrored bits, with the exceptions of
    /// [`Mover::move_and_slide`]. A box or polygon that snaps into a V and meets both slopes at
    /// once takes the one whose normal points to +x. Tiles and polygons of the same ground give the
    /// same bits to boxes, circles and capsules. Exceptions are corners that a box meets to the raw
    /// unit, and steps onto ledges that overhang.
    ///
    /// A walker stops up to 4 raw units before a wall.
    ///
    /// A step leads to any floor, level or sloping. A circle climbs by its lowest point, which
    /// takes several frames, and the ground one radius farther on must not be higher than the
    /// step. So does a polygon by a foot that is narrower than its body. Their `floor` is then the
    /// one that the step leads to. On the way down around an edge it is the floor ahead, which is
    /// lower by up to the snap. There [`Mover::supported`] may find no floor. An edge that they
    /// meet no steeper than the slope limit is no step. Snapping and steps treat one-way faces as
    /// every motion does: the faces hold bodies that are entirely above them.
    ///
    /// Cost: on even ground, two sweeps over the cells under the motion. At most four legs with two
    /// sweeps each; trying a step takes up to ten more.
    ///
    /// ```
    /// use tilesat::{Aabb, Axis, Fx, Mover, SlopeSpeed, Slopes, TileKind, TileKinds, TileMap, TileShape, Vec2, Walker};
    /// static KINDS: TileKinds = TileKinds::EMPTY
    ///     .with(b'#', TileKind::FULL)
    ///     .with(b'/', TileKind::of(TileShape::SlopeBottomRight));
    /// // The floor is at y = 32, and at 16 from x = 48 on.
    /// let map = TileMap::from_ascii("....\n../#\n####", &TileKinds::EMPTY)?.with_kinds::<Slopes>(&KINDS)?;
    /// let walker = Walker::new(Mover::platformer(Axis::NEG_Y))
    ///     .with_slope_speed(SlopeSpeed::Constant)
    ///     .with_snap(Fx::from_num(4))?;
    ///
    /// let player = Aabb::new(Vec2::from_ints(4, 20), Vec2::from_ints(12, 30))?;
    /// let mut walked = walker.walk(&map, &player, Vec2::from_ints(0, 3), None)?; // it lands
    /// assert!(walked.on_floor());
    /// for _ in 0..16 {
    ///     let velocity = Vec2::from_ints(2, 1); // gravity changes nothing on the ground
    ///     walked = walker.walk(&map, &walked.moved.body, velocity, walked.floor)?;
    /// }
    /// assert_eq!(walked.floor.map(|floor| floor.axis), Some(Axis::new(-1, -1))); // on its way up the slope
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`Mover::move_and_slide`].
    ///
    /// [`Mover::move_and_slide`]: crate::Mover::move_and_slide
    /// [`Mover::supported`]: crate::Mover::supported
    pub fn walk<W: World, B: Body>(
        &self,
        world: &W,
        body: &B,
        velocity: Vec2,
        floor: Option<Support>,
    ) -> Result<Walked<B>, MoveError> {
        let mut moved = Moved::freely(*body, velocity, 0);
        let Footing { floor, met_floor, stepped, snapped } = self.walk_in_place(world, &mut moved, floor)?;
        Ok(Walked { moved, floor, met_floor, stepped, snapped })
    }

    /// [`walk`](Self::walk) for a motion that is written where it is.
    #[inline]
    pub(in crate::motion) fn walk_in_place<W: World, B: Body>(
        &self,
        world: &W,
        moved: &mut Moved<B>,
        floor: Option<Support>,
    ) -> Result<Footing, MoveError> {
        let (body, velocity) = (moved.body, moved.velocity);
        let mut around = Around::nothing();
        let mut run = self.mover.start(world, moved, &mut around)?;
        let reach = self.snap.max(self.step);
        check_cells(world, body.extent(), Raw { x: reach, y: reach })?;
        let footing = self.go(world, &mut run, floor)?;
        // It came to a floor that neither carries it nor lets it walk: the foot of a ramp beside
        // it, under a ceiling. That is no landing, and gravity may still have a way. A box stands
        // on every level floor that it meets.
        let stays = footing.floor.is_none() && run.moved.floor && run.v.is_zero();
        if may_be_askew::<B, W>() && stays && run.moved.body.bounds() == body.bounds() {
            *moved = Moved::freely(body, velocity, 0);
            return self.fall(world, moved);
        }
        run.end::<W>();
        Ok(footing)
    }

    /// A frame in which floors do not end the fall.
    #[cold]
    #[inline(never)]
    fn fall<W: World, B: Body>(&self, world: &W, moved: &mut Moved<B>) -> Result<Footing, MoveError> {
        let mut around = Around::nothing();
        let mut run = self.mover.start(world, moved, &mut around)?;
        run.falls = true;
        self.mover.slide::<W, B, true>(world, &mut run, &mut First::none())?;
        let footing = self.fly(world, &mut run);
        run.end::<W>();
        Ok(footing)
    }

    /// Makes the motion of a frame.
    fn go<W: World, B: Body>(
        &self,
        world: &W,
        run: &mut Run<'_, B>,
        floor: Option<Support>,
    ) -> Result<Footing, MoveError> {
        let (passes, rises) = (self.mover.passes_one_way(), self.mover.up.is_some_and(|up| leads(run.v, up)));
        let stands = floor.filter(|f| !(rises || (passes && f.one_way))).map(|f| f.axis);
        let axis = if stands.is_none() || self.mover.up.is_none() {
            self.mover.slide::<W, B, true>(world, run, &mut First::none())?;
            run.moved.hits.last().filter(|_| run.moved.floor).map(|hit| hit.axis)
        } else {
            stands
        };
        if let (Some(axis), Some(up)) = (axis, self.mover.up) {
            run.pass_one_way |= passes;
            return Stride::new(self, world, run, up, axis).walk();
        }
        Ok(self.fly(world, run))
    }

    /// The end of a frame in the air. A body whose velocity does not lead up or down may stand.
    #[inline(never)]
    fn fly<W: World, B: Body>(&self, world: &W, run: &mut Run<'_, B>) -> Footing {
        run.pass_one_way |= self.mover.passes_one_way();
        let level = self.mover.up.filter(|&up| !(leads(run.v, up) || leads(run.v, up.reversed())));
        let floor = level.and_then(|up| run.floor_near(world, &self.mover, up));
        Footing { floor, met_floor: floor.is_some(), stepped: Fx::ZERO, snapped: Fx::ZERO }
    }
}
