//! Operations on a broad phase, run beside the reference.

use super::near::Near;
use super::reference::{Body, DOMAIN, Model, P, Rect};
use super::{Cells, Mark, aabb, vec2};
use std::collections::HashSet;
use tilesat::broad::{BroadError, BroadHit, Handle, Nearest, Pair, PairCursor, PairsError, QueryError};
use tilesat::heapless::{Vec as Room, VecView};
use tilesat::{Aabb, Fx, Quantity, RangeError, Toi, error::Truncated};

/// A coordinate: quarters of a cell and a few raw units beside them.
pub type At = (i64, i64);

/// A box: its first corner, and the size of its sides as an index.
pub type Shape = (At, At, usize, usize);

#[derive(Clone, Debug)]
pub enum Op {
    Insert(Shape, u32, u8),
    Move(usize, Shape),
    MoveEach(At, At),
    Remove(usize),
    SetTag(usize, u32, u8),
    Save,
    Restore,
    Pairs,
    Sorted(usize),
    /// Budgets, rooms, and the bodies to remove or to move in between.
    From(Vec<(u32, usize, Option<usize>, Option<usize>)>),
    Of(Vec<usize>),
    Region(Shape, usize),
    Point(At, At),
    /// The start, the distance in quarters, whether without a team, and the room.
    Near(At, At, At, u8, usize),
    Ray(At, At, At, At, u8, usize),
    Cast(Shape, At, At, u8, usize),
}

/// A structure, and its expected content.
pub struct Play {
    name: String,
    phase: Near<Mark>,
    model: Model,
    limit: Option<i32>,
    cells: Cells,
    saved: Option<(Near<Mark>, Model)>,
    /// The queries so far, so that none is without effect.
    pub pairs: u64,
    pub hits: u64,
}

fn with_room<T>(room: usize, ask: impl FnOnce(&mut VecView<T>)) {
    match room {
        0 => ask(&mut Room::<T, 0>::new()),
        1 => ask(&mut Room::<T, 1>::new()),
        2 => ask(&mut Room::<T, 2>::new()),
        3 => ask(&mut Room::<T, 3>::new()),
        4 => ask(&mut Room::<T, 7>::new()),
        _ => ask(&mut Room::<T, 600>::new()),
    }
}

/// The first expected results, and the expected error.
fn cut<T: Clone>(all: &[T], room: usize) -> (Vec<T>, Result<(), Truncated>) {
    let kept = all.len().min(room);
    let told = Truncated { seen: all.len() as u32, kept: kept as u32 };
    (all[..kept].to_vec(), if kept == all.len() { Ok(()) } else { Err(told) })
}

impl Play {
    pub fn new(name: &str, limit: Option<i32>, cells: Cells, empty: &Near<Mark>) -> Self {
        Self {
            name: format!("{name}, {cells:?}"),
            phase: empty.clone(),
            model: Model::default(),
            limit,
            cells,
            saved: None,
            pairs: 0,
            hits: 0,
        }
    }

    fn at(&self, axis: usize, (quarters, rest): At) -> i64 {
        let origin = [self.cells.origin.0, self.cells.origin.1][axis];
        (i64::from(origin) + quarters * i64::from(self.cells.side) / 4 + rest).clamp(1 - DOMAIN, DOMAIN - 1)
    }

    fn place(&self, x: At, y: At) -> P {
        (self.at(0, x), self.at(1, y))
    }

    fn shape(&self, (x, y, w, h): Shape) -> Aabb {
        let (lo, side) = (self.place(x, y), i64::from(self.cells.side));
        let size = |i: usize| [0, 1, 2, side / 4, side / 2 + 1, side - 1, side, side + 1, 3 * side][i];
        aabb(lo, ((lo.0 + size(w)).min(DOMAIN - 1), (lo.1 + size(h)).min(DOMAIN - 1)))
    }

    fn body(&self, which: usize) -> Option<Body> {
        self.model.bodies.get(which % self.model.bodies.len().max(1)).copied()
    }

    /// Boxes refused because of their size.
    fn refusal(&self, bounds: &Aabb) -> Option<BroadError> {
        let size = i32::try_from(Rect::of(bounds).side()).unwrap();
        self.limit.filter(|limit| size > *limit).map(|limit| BroadError::TooLarge { size, limit })
    }

    fn set(&mut self, handle: Handle, change: impl FnOnce(&mut Body)) {
        change(self.model.bodies.iter_mut().find(|body| body.handle == handle).unwrap());
    }

    pub fn play(&mut self, op: &Op) {
        match op {
            Op::Insert(shape, key, team) => self.insert(&self.shape(*shape), Mark::new(*key, *team)),
            Op::Move(which, shape) => self.move_to(*which, &self.shape(*shape)),
            Op::MoveEach(x, y) => self.move_each(*x, *y),
            Op::Remove(which) => self.remove(*which),
            Op::SetTag(which, key, team) => {
                let Some(body) = self.body(*which) else { return };
                let mark = Mark::new(*key, *team);
                assert_eq!(self.phase.set_tag(body.handle, mark), Ok(()));
                self.set(body.handle, |body| body.mark = mark);
            }
            Op::Save => self.saved = Some((self.phase.clone(), self.model.clone())),
            Op::Restore => {
                if let Some((phase, model)) = &self.saved {
                    (self.phase, self.model) = (phase.clone(), model.clone());
                }
            }
            Op::Pairs => self.all_pairs(),
            Op::Sorted(room) => self.sorted(*room),
            Op::From(steps) => self.resumed(steps),
            Op::Of(movers) => self.of_movers(movers),
            Op::Region(shape, room) => self.region(&self.shape(*shape), *room),
            Op::Point(x, y) => self.point(self.place(*x, *y)),
            Op::Near(x, y, within, team, room) => {
                let within = (within.0 * i64::from(self.cells.side) / 4 + within.1).clamp(-1, i32::MAX.into());
                self.near(self.place(*x, *y), within, *team, *room);
            }
            Op::Ray(x, y, dx, dy, team, room) => {
                let from = self.place(*x, *y);
                let to = (self.at(0, (x.0 + dx.0, x.1 + dx.1)), self.at(1, (y.0 + dy.0, y.1 + dy.1)));
                self.cast(&aabb(from, from), (to.0 - from.0, to.1 - from.1), *team, *room, true);
            }
            Op::Cast(shape, dx, dy, team, room) => {
                let quarter = i64::from(self.cells.side) / 4;
                let component = |d: At| (d.0 * quarter + d.1).clamp(i32::MIN.into(), i32::MAX.into());
                let d = (component(*dx), component(*dy));
                self.cast(&self.shape(*shape), d, *team, *room, false);
            }
        }
        assert_eq!(self.phase.len(), self.model.bodies.len(), "{}", self.name);
        assert_eq!(self.phase.is_empty(), self.model.bodies.is_empty(), "{}", self.name);
    }

    /// The content of every body, and that no other handle is valid.
    pub fn look(&self) {
        for body in &self.model.bodies {
            assert_eq!(self.phase.bounds(body.handle).map(|b| Rect::of(&b)), Ok(body.rect), "{}", self.name);
            assert_eq!(self.phase.tag(body.handle), Ok(body.mark), "{}", self.name);
        }
        let mut bodies: Vec<_> = self.model.bodies.iter().map(|body| (body.handle, body.rect, body.mark)).collect();
        bodies.sort_by_key(|(handle, ..)| handle.slot());
        let told = self.phase.bodies().map(|(handle, bounds, mark)| (handle, Rect::of(&bounds), mark));
        assert!(told.eq(bodies), "{}", self.name);
        let here: HashSet<_> = self.model.bodies.iter().map(|body| body.handle).collect();
        for handle in &self.model.issued {
            assert_eq!(self.phase.contains(*handle), here.contains(handle), "{}", self.name);
        }
    }

    fn insert(&mut self, bounds: &Aabb, mark: Mark) {
        let told = self.phase.insert(bounds, mark);
        if let Some(error) = self.refusal(bounds) {
            assert_eq!(told, Err(error), "{}", self.name);
            return;
        }
        match told {
            Ok(handle) => {
                assert!(!self.model.issued.contains(&handle), "{handle:?} is new, {}", self.name);
                self.model.issued.push(handle);
                self.model.bodies.push(Body { handle, rect: Rect::of(bounds), mark });
            }
            Err(BroadError::Full { capacity }) => assert_eq!(usize::from(capacity), self.model.bodies.len()),
            Err(error) => panic!("{error}, {}", self.name),
        }
    }

    fn move_to(&mut self, which: usize, bounds: &Aabb) {
        let Some(body) = self.body(which) else { return };
        let told = self.phase.move_to(body.handle, bounds);
        if let Some(error) = self.refusal(bounds) {
            assert_eq!(told, Err(error), "{}", self.name);
        } else {
            assert_eq!(told, Ok(()), "{}", self.name);
            self.set(body.handle, |body| body.rect = Rect::of(bounds));
        }
    }

    /// All by one step. Those that would leave the domain stay, and every seventh slot grows wider
    /// than a cell.
    fn move_each(&mut self, x: At, y: At) {
        let side = i64::from(self.cells.side);
        let d = (x.0 * side / 4 + x.1, y.0 * side / 4 + y.1);
        let to = |handle: Handle, rect: &Rect| {
            let mut to = rect.moved(d);
            to.hi.0 += if handle.slot() % 7 == 3 { 2 * side } else { 0 };
            if to.in_domain() { to } else { *rect }
        };
        let mut seen = Vec::new();
        let told = self.phase.move_each(|handle, bounds| {
            seen.push((handle, Rect::of(bounds)));
            let to = to(handle, &Rect::of(bounds));
            aabb(to.lo, to.hi)
        });
        let mut expected: Vec<_> = self.model.bodies.iter().map(|body| (body.handle, body.rect)).collect();
        expected.sort_by_key(|(handle, _)| handle.slot());
        seen.sort_by_key(|(handle, _)| handle.slot());
        assert_eq!(seen, expected, "{}", self.name);
        let mut first = Ok(());
        for (handle, rect) in expected {
            let to = to(handle, &rect);
            match self.refusal(&aabb(to.lo, to.hi)) {
                Some(error) => first = first.and(Err((handle, error))),
                None => self.set(handle, |body| body.rect = to),
            }
        }
        assert_eq!(told, first, "{}", self.name);
    }

    fn remove(&mut self, which: usize) {
        let Some(Body { handle, mark, .. }) = self.body(which) else { return };
        assert_eq!(self.phase.remove(handle), Ok(mark), "{}", self.name);
        self.model.bodies.retain(|body| body.handle != handle);
        let stale = BroadError::Stale(handle);
        let bounds = aabb((0, 0), (1, 1));
        assert_eq!(self.phase.remove(handle), Err(stale));
        assert_eq!(self.phase.move_to(handle, &bounds), Err(stale));
        assert_eq!(self.phase.set_tag(handle, mark), Err(stale));
        assert_eq!(self.phase.bounds(handle), Err(stale));
        assert_eq!(self.phase.tag(handle), Err(stale));
        assert_eq!(self.phase.pairs_of(&[handle], |_| panic!("a pair of none")), Err(stale));
    }

    fn all_pairs(&mut self) {
        let expected = self.model.pairs();
        let mut pairs = Vec::new();
        self.phase.pairs(|pair| pairs.push((pair.a, pair.b)));
        self.compare(pairs, &expected);
    }

    /// As sets, each pair once and the right way round.
    fn compare(&mut self, mut pairs: Vec<(Handle, Handle)>, expected: &[(Handle, Handle)]) {
        self.pairs += pairs.len() as u64;
        let key = |handle: &Handle| self.model.find(*handle).mark.key;
        pairs.sort_by_key(|(a, b)| (key(a), key(b), a.slot(), b.slot()));
        assert_eq!(pairs, expected, "{}", self.name);
    }

    fn sorted(&mut self, room: usize) {
        let all = self.model.pairs();
        with_room::<Pair>(room, |out| {
            let told = self.phase.pairs_sorted(out);
            let (expected, cut) = cut(&all, out.capacity());
            let pairs: Vec<_> = out.iter().map(|pair| (pair.a, pair.b)).collect();
            assert_eq!((pairs, told), (expected, cut), "{}", self.name);
        });
    }

    /// The result is the set that was near at the start and was not removed. No pair comes twice,
    /// and none with a body that was gone.
    fn resumed(&mut self, steps: &[(u32, usize, Option<usize>, Option<usize>)]) {
        let (mut cursor, mut pairs) = (PairCursor::new(), Vec::new());
        let mut near: HashSet<_> = self.model.pairs().into_iter().collect();
        let rest = std::iter::repeat_n(&(9, 2, None, None), 2000);
        for (budget, room, remove, disturb) in steps.iter().chain(rest) {
            let mut done = false;
            with_room::<Pair>(*room, |out| {
                let told = self.phase.pairs_from(&mut cursor, *budget, out);
                if told == Err(PairsError::Full) {
                    assert!(out.is_full());
                }
                for pair in &*out {
                    assert!(self.phase.contains(pair.a) && self.phase.contains(pair.b), "{}", self.name);
                    pairs.push((pair.a, pair.b));
                }
                done = told.is_ok();
                assert_ne!(told, Err(PairsError::Changed), "{}", self.name);
            });
            if done {
                assert_eq!(cursor, PairCursor::new(), "{}", self.name);
                let set: HashSet<_> = pairs.iter().copied().collect();
                assert_eq!(set.len(), pairs.len(), "a pair came twice, {}", self.name);
                assert!(set.is_subset(&near), "{}", self.name);
                assert!(self.model.pairs().iter().all(|pair| set.contains(pair)), "{}", self.name);
                self.pairs += pairs.len() as u64;
                return;
            }
            if let Some(which) = remove {
                self.remove(*which);
            }
            if let Some(body) = disturb.and_then(|which| self.body(which)) {
                let bounds = aabb(body.rect.lo, body.rect.lo);
                self.phase.move_to(body.handle, &bounds).unwrap();
                self.set(body.handle, |body| body.rect = Rect::of(&bounds));
                let told = self.phase.pairs_from(&mut cursor, 100, &mut Room::<Pair, 100>::new());
                assert_eq!(told, Err(PairsError::Changed), "{}", self.name);
                assert_eq!(cursor, PairCursor::new(), "{}", self.name);
                pairs.clear();
                near = self.model.pairs().into_iter().collect();
            }
        }
        panic!("an enumeration without end, {}", self.name);
    }

    fn of_movers(&mut self, movers: &[usize]) {
        let movers: Vec<_> = movers.iter().filter_map(|which| self.body(*which)).map(|body| body.handle).collect();
        let expected: Vec<_> =
            self.model.pairs().into_iter().filter(|(a, b)| movers.contains(a) || movers.contains(b)).collect();
        let mut pairs = Vec::new();
        let told = self.phase.pairs_of(&movers, |pair| pairs.push((pair.a, pair.b)));
        assert_eq!(told, Ok(()), "{}", self.name);
        self.compare(pairs, &expected);
        self.look();
    }

    fn region(&mut self, region: &Aabb, room: usize) {
        let rect = Rect::of(region);
        let all = self.model.all(|body| body.rect.touches(&rect));
        self.hits += all.len() as u64;
        let mut seen = Vec::new();
        self.phase.in_region(region, |handle| seen.push(handle));
        seen.sort_by_key(|handle| self.model.find(*handle).rank());
        assert_eq!(seen, all, "{}", self.name);
        with_room::<Handle>(room, |out| {
            let told = self.phase.collect_region(region, out);
            assert_eq!((out.to_vec(), told), cut(&all, out.capacity()), "{}", self.name);
        });
    }

    fn point(&mut self, p: P) {
        let mut seen = Vec::new();
        self.phase.at_point(vec2(p), |handle| seen.push(handle));
        seen.sort_by_key(|handle| self.model.find(*handle).rank());
        assert_eq!(seen, self.model.all(|body| body.rect.touches(&Rect { lo: p, hi: p })), "{}", self.name);
    }

    fn near(&mut self, p: P, within: i64, team: u8, room: usize) {
        let wanted = |body: &Body| body.mark.team != team;
        let all = self.model.near(p, within, wanted);
        self.hits += all.len() as u64;
        let (from, reach) = (vec2(p), Fx::from_bits(i32::try_from(within).unwrap()));
        let mut asked = HashSet::new();
        let mut want = |handle: Handle, mark: &Mark| {
            assert!(asked.insert(handle), "{handle:?} was asked twice, {}", self.name);
            assert_eq!(*mark, self.model.find(handle).mark);
            mark.team != team
        };
        let told = self.phase.nearest(from, reach, &mut want);
        if within < 0 {
            let error = RangeError { what: Quantity::Radius, value: reach.to_bits() };
            assert_eq!(told, Err(error), "{}", self.name);
            return;
        }
        let found = told.unwrap().map(|near| (near.handle, i64::from(near.distance.to_bits())));
        assert_eq!(found, all.first().copied(), "{}", self.name);
        with_room::<Nearest>(room, |out| {
            let told = self.phase.neighbours(from, reach, |_, mark| mark.team != team, out);
            let seen: Vec<_> = out.iter().map(|n| (n.handle, i64::from(n.distance.to_bits()))).collect();
            let (expected, cut) = cut(&all, out.capacity());
            assert_eq!((seen, told), (expected, cut.map_err(QueryError::Truncated)), "{}", self.name);
        });
    }

    fn cast(&mut self, start: &Aabb, d: P, team: u8, room: usize, ray: bool) {
        let rect = Rect::of(start);
        let motion = vec2(d);
        let mut seen = Vec::new();
        let told = self.phase.along(start, motion, |handle, mark, toi| {
            assert_eq!(*mark, self.model.find(handle).mark);
            seen.push((toi.raw(), self.model.find(handle).rank(), handle));
            Toi::ONE
        });
        if !rect.moved(d).in_domain() {
            assert!(matches!(told, Err(RangeError { what: Quantity::EndX | Quantity::EndY, .. })));
            assert!(seen.is_empty());
            return;
        }
        assert_eq!(told, Ok(()), "{}", self.name);
        seen.sort_unstable();
        let every: Vec<_> = seen.iter().map(|hit| (hit.2, hit.0)).collect();
        assert_eq!(every, self.model.touched(&rect, d, |_| true), "{}", self.name);
        let all = self.model.touched(&rect, d, |body| body.mark.team != team);
        self.hits += all.len() as u64;
        with_room::<BroadHit>(room, |out| {
            let wanted = |_, mark: &Mark| mark.team != team;
            let told = if ray {
                self.phase.cast_ray(start.min(), motion, wanted, out)
            } else {
                self.phase.cast_shape(start, motion, wanted, out)
            };
            let hits: Vec<_> = out.iter().map(|hit| (hit.handle, hit.toi.raw())).collect();
            let (expected, cut) = cut(&all, out.capacity());
            assert_eq!((hits, told), (expected, cut.map_err(QueryError::Truncated)), "{}", self.name);
        });
        // A caller that stops at the first wanted body sees all that are not later, and nobody
        // twice.
        let (mut limit, mut first) = (Toi::ONE, Vec::new());
        self.phase
            .along(start, motion, |handle, mark, toi| {
                assert!(toi <= limit && !first.contains(&handle), "{}", self.name);
                first.push(handle);
                limit = if mark.team == team { limit } else { limit.min(toi) };
                limit
            })
            .unwrap();
        assert!(every.iter().all(|(handle, toi)| *toi > limit.raw() || first.contains(handle)), "{}", self.name);
    }
}
