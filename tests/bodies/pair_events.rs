//! Events of pairs and exceptions, compared with sets from the definitions: all frames of a few
//! pairs, many frames of many, and bodies that move, rest and leave.

use std::collections::{BTreeMap, BTreeSet};
use tilesat::broad::{BroadError, BroadPhase, BruteForce, Exceptions, Handle, Ignore, Pair, PairEvent, PairEvents};
use tilesat::{Aabb, Filter, LayerMask, Vec2, error::Truncated};
use tilesat_judge::Random;

type Told = (Vec<PairEvent<u8>>, Result<(), Truncated>);

/// The expected events, from the pairs of the last frame. Then these become the pairs of this
/// frame.
fn model(room: usize, last: &mut BTreeSet<u8>, fed: &[u8], held: &dyn Fn(u8) -> bool) -> Told {
    let came: BTreeSet<u8> = fed.iter().copied().collect();
    let new: Vec<u8> = came.difference(last).copied().collect();
    let fits = new.len().min(room - last.len());
    let mut events = BTreeMap::new();
    for &pair in last.iter() {
        let stays = came.contains(&pair) || held(pair);
        events.insert(pair, if stays { PairEvent::Stay(pair) } else { PairEvent::End(pair) });
    }
    events.extend(new[..fits].iter().map(|&pair| (pair, PairEvent::Begin(pair))));
    let kept = (came.len() - new.len() + fits) as u32;
    let done = if fits < new.len() { Err(Truncated { seen: fed.len() as u32, kept }) } else { Ok(()) };
    *last = events.iter().filter(|(_, event)| !matches!(event, PairEvent::End(_))).map(|(&pair, _)| pair).collect();
    (events.into_values().collect(), done)
}

fn play<const M: usize>(events: &mut PairEvents<M, u8>, fed: &[u8], held: impl Fn(u8) -> bool) -> Told {
    for &pair in fed {
        events.feed(pair);
    }
    let done = events.finish(|&pair| held(pair));
    (events.iter().collect(), done)
}

/// Every frame after every possible frame: all orders of feeding up to four of four pairs, with all
/// subsets at rest.
fn every_frame<const M: usize>() -> usize {
    let mut feeds = vec![vec![]];
    for from in 0.. {
        let Some(feed) = feeds.get(from).cloned().filter(|feed: &Vec<u8>| feed.len() < 4) else { break };
        feeds.extend((0..4).map(|pair| [feed.as_slice(), &[pair]].concat()));
    }
    assert_eq!(feeds.len(), 1 + 4 + 16 + 64 + 256);
    let mut states = vec![(PairEvents::<M, u8>::new(), BTreeSet::new())];
    // The map has places in the list. With the bits in it, it would be compiled for each `M`.
    let (mut known, mut kept, mut seen) = (BTreeMap::new(), Vec::new(), BTreeSet::from([vec![]]));
    for from in 0.. {
        let Some((events, last)) = states.get(from).cloned() else { break };
        for feed in &feeds {
            for rests in 0..16 {
                let held = |pair| rests >> pair & 1 == 1;
                let (mut events, mut last) = (events, last.clone());
                let expected = model(M, &mut last, feed, &held);
                assert_eq!(play(&mut events, feed, held), expected, "M={M} {last:?} {feed:?} {rests:b}");
                assert!(events.pairs().eq(last.iter().copied()));
                assert!((0..5).all(|pair| events.contains(pair) == last.contains(&pair)));
                // The reported pairs are the whole state. Equal states are equal bits, whatever
                // came before and in whichever order, except for counts.
                let mut bits = events;
                bits.feed(9);
                bits.cancel();
                assert_eq!(bits.iter().count(), 0);
                let at = *known.entry(last.clone()).or_insert(kept.len());
                if at == kept.len() {
                    kept.push(bits);
                }
                assert_eq!(kept[at], bits);
                if seen.insert(expected.0) {
                    states.push((events, last));
                }
            }
        }
    }
    states.len()
}

#[test]
fn all_frames_of_four_pairs() {
    // Each of k pairs began, stays or ended; M pairs at most.
    assert_eq!(every_frame::<0>(), 1);
    assert_eq!(every_frame::<1>(), 1 + 4 * 3);
    assert_eq!(every_frame::<2>(), 1 + 4 * 3 + 6 * 9);
    assert_eq!(every_frame::<3>(), 1 + 4 * 3 + 6 * 9 + 4 * 27);
    assert_eq!(every_frame::<4>(), 256);
    assert_eq!(every_frame::<5>(), 256);
}

fn many_frames<const M: usize>(seed: u64) {
    let mut r = Random::new(seed);
    let (mut events, mut last) = (PairEvents::<M, u8>::default(), BTreeSet::new());
    let mut truncated = 0;
    for _ in 0..4000 {
        // Some frames far beyond the room. Pairs return soon, so that many stay.
        let span = r.within(1, 3 * M as i64);
        let fed: Vec<u8> = (0..r.below(2 * span)).map(|_| r.below(span) as u8).collect();
        let rests = r.next();
        if r.one_in(8) {
            for &pair in &fed {
                events.feed(pair);
            }
            assert!(events.pairs().eq(last.iter().copied()), "nothing is told before `finish`");
            events.cancel();
            assert!(events.pairs().eq(last.iter().copied()));
        }
        let held = |pair| rests >> (pair % 64) & 1 == 1;
        let expected = model(M, &mut last, &fed, &held);
        assert_eq!(play(&mut events, &fed, held), expected);
        truncated += u32::from(expected.1.is_err());
    }
    assert!((400..3900).contains(&truncated), "{truncated}");
}

#[test]
fn many_frames_of_many_pairs() {
    many_frames::<1>(1);
    many_frames::<7>(2);
    many_frames::<64>(3);
}

#[test]
fn any_ordered_value_is_a_pair() {
    const TRAP: (i32, i32) = (3, 4);
    static EMPTY: PairEvents<4, (u8, (i32, i32))> = PairEvents::new();
    let mut events = EMPTY;
    events.feed((7, TRAP));
    assert_eq!(events.finish(|_| false), Ok(()));
    let told: Vec<_> = events.iter().collect();
    assert_eq!(told, [PairEvent::Begin((7, TRAP))]);
    assert_eq!(told[0].pair(), (7, TRAP));
}

/// A body of the model: numbers that are never reused, and plain integers.
#[derive(Clone, Debug)]
struct Shadow {
    id: u32,
    handle: Handle,
    at: (i16, i16),
    size: i16,
    filter: Filter,
}

impl Shadow {
    fn bounds(&self) -> Aabb {
        let (x, y) = self.at;
        Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + self.size, y + self.size)).unwrap()
    }

    /// The game's own test: interiors meet.
    fn meets(&self, other: &Self) -> bool {
        let near = |a: i16, b: i16| a < b + other.size && b < a + self.size;
        near(self.at.0, other.at.0) && near(self.at.1, other.at.1)
    }

    fn wants(&self, other: &Self) -> bool {
        let one_way = |a: &Filter, b: &Filter| a.mask.0 & b.layers.0 != 0;
        let (a, b) = (&self.filter, &other.filter);
        one_way(a, b) && one_way(b, a) && !(a.sensor() && b.sensor())
    }
}

const BODIES: usize = 14;

fn newcomer(r: &mut Random, near: &mut BruteForce<BODIES, Filter>, id: u32) -> Shadow {
    let layers = LayerMask(r.within(1, 3) as u16);
    let filter = Filter::new(layers, LayerMask(r.within(1, 3) as u16)).with_sensor(r.one_in(4));
    let (at, size) = ((r.below(30) as i16, r.below(30) as i16), r.within(4, 12) as i16);
    let bounds = Aabb::new(Vec2::from_ints(at.0, at.1), Vec2::from_ints(at.0 + size, at.1 + size)).unwrap();
    Shadow { id, handle: near.insert(&bounds, filter).unwrap(), at, size, filter }
}

/// Bodies that move, fall asleep, wake, leave and are replaced by others in the same slot.
#[test]
fn bodies_that_move_rest_and_leave() {
    let mut r = Random::new(4);
    let mut near = BruteForce::<BODIES, Filter>::new();
    let mut events = PairEvents::<{ BODIES * BODIES }>::new();
    let mut exceptions = Exceptions::<8>::new();
    let (mut bodies, mut next) = (Vec::<Shadow>::new(), 0);
    let mut ids = BTreeMap::new();
    let mut last = BTreeSet::new();
    let (mut slept, mut old_names, mut counts) = (0, 0, [0; 3]);
    for _ in 0..6000 {
        while !bodies.is_empty() && r.one_in(3) {
            let gone = bodies.swap_remove(r.below(bodies.len() as i64) as usize);
            near.remove(gone.handle).unwrap();
        }
        while bodies.len() < BODIES && r.one_in(2) {
            bodies.push(newcomer(&mut r, &mut near, next));
            ids.insert(bodies.last().unwrap().handle, next);
            next += 1;
        }
        for body in &mut bodies {
            if body.filter.still() && !r.one_in(12) {
                continue;
            }
            body.at.0 += r.around(3) as i16;
            body.at.1 += r.around(3) as i16;
            body.filter = body.filter.with_still(false);
            near.move_to(body.handle, &body.bounds()).unwrap();
            near.set_tag(body.handle, body.filter).unwrap();
        }

        let find = |handle: Handle| bodies.iter().find(|body| body.handle == handle).unwrap();
        near.pairs(|pair| {
            if find(pair.a).meets(find(pair.b)) && exceptions.passes(pair) {
                events.feed(pair);
            }
        });
        let rests = |handle| near.tag(handle).is_ok_and(|filter| filter.still());
        events.finish(|pair| rests(pair.a) && rests(pair.b)).unwrap();
        let told: Vec<_> = events.iter().collect();
        assert!(told.is_sorted_by_key(PairEvent::pair));

        let mut now = BTreeSet::new();
        for (i, a) in bodies.iter().enumerate() {
            for b in &bodies[..i] {
                let key = (a.id.min(b.id), a.id.max(b.id));
                let rest = a.filter.still() && b.filter.still();
                slept += u32::from(rest && last.contains(&key));
                if if rest { last.contains(&key) } else { a.wants(b) && a.meets(b) } {
                    now.insert(key);
                }
            }
        }
        let mut seen: [BTreeSet<(u32, u32)>; 3] = Default::default();
        for event in &told {
            let pair = event.pair();
            let (a, b) = (ids[&pair.a], ids[&pair.b]);
            let kind = match event {
                PairEvent::Begin(_) => 0,
                PairEvent::Stay(_) => 1,
                PairEvent::End(_) => 2,
            };
            old_names += u32::from(kind == 2 && !(near.contains(pair.a) && near.contains(pair.b)));
            assert!(seen[kind].insert((a.min(b), a.max(b))));
            counts[kind] += 1;
        }
        let expected: [BTreeSet<(u32, u32)>; 3] = [&now - &last, &now & &last, &last - &now];
        assert_eq!(seen, expected);
        last = now;

        for body in &mut bodies {
            if r.one_in(10) {
                body.filter = body.filter.with_still(true);
                near.set_tag(body.handle, body.filter).unwrap();
            }
        }
    }
    assert!(slept > 2000 && old_names > 1000 && counts.iter().all(|&n| n > 3000), "{slept} {old_names} {counts:?}");
}

/// The calls as made. The end of a rule follows from its history.
#[derive(Clone, Debug)]
struct Asked {
    ignore: Ignore,
    this_frame: bool,
    came: bool,
}

type Terms = BTreeMap<usize, Asked>;

fn ask(terms: &mut Terms, room: usize, pair: usize, ignore: Ignore) -> bool {
    let fits = terms.contains_key(&pair) || terms.len() < room;
    if fits {
        terms.insert(pair, Asked { ignore, this_frame: true, came: false });
    }
    fits
}

/// All frames of all exceptions of three bodies: set before or after the pairs came, with the
/// handles in either order.
fn every_exception<const M: usize>() -> usize {
    const NAMES: [(usize, usize); 3] = [(0, 1), (0, 2), (1, 2)];
    let mut near = BruteForce::<3>::new();
    let unit = Aabb::new(Vec2::ZERO, Vec2::from_ints(1, 1)).unwrap();
    let handles = [0; 3].map(|_| near.insert(&unit, ()).unwrap());
    let pair = |i: usize, turned: bool| {
        let (a, b) = (handles[NAMES[i].0], handles[NAMES[i].1]);
        if turned { Pair { a: b, b: a } } else { Pair { a, b } }
    };
    let mut wishes = vec![None];
    for ignore in [Ignore::Once, Ignore::UntilApart, Ignore::UntilRemoved] {
        wishes.extend((0..3).map(|i| Some((i, ignore))));
    }
    let mut states = vec![(Exceptions::<M>::new(), Terms::new())];
    for from in 0.. {
        let Some((start, known)) = states.get(from).cloned() else { break };
        for code in 0..wishes.len() * 2 * 8 * 8 * 4 {
            let (wish, rest) = (wishes[code % wishes.len()], code / wishes.len());
            let (late, came, rests, gone) = (rest % 2 == 1, rest / 2 % 8, rest / 16 % 8, rest / 128);
            let (mut exceptions, mut terms) = (start, known.clone());
            let say = |exceptions: &mut Exceptions<M>, terms: &mut Terms| {
                let Some((i, ignore)) = wish else { return };
                let Pair { a, b } = pair(i, late);
                let before = *exceptions;
                let said = exceptions.ignore(a, b, ignore);
                assert_eq!(said.is_ok(), ask(terms, M, i, ignore));
                if said.is_err() {
                    assert_eq!((said, *exceptions), (Err(BroadError::Full { capacity: M as u16 }), before));
                }
            };
            if !late {
                say(&mut exceptions, &mut terms);
            }
            for i in (0..3).filter(|i| came >> i & 1 == 1) {
                for turned in [false, true] {
                    assert_eq!(exceptions.passes(pair(i, turned)), !terms.contains_key(&i));
                }
                terms.entry(i).and_modify(|asked| asked.came = true);
            }
            if late {
                say(&mut exceptions, &mut terms);
            }
            let index = |known: &Pair| (0..3).find(|&i| pair(i, false) == *known).unwrap();
            exceptions.finish(|handle| gone == 3 || handle != handles[gone], |known| rests >> index(known) & 1 == 1);
            terms.retain(|&i, asked| {
                let stays = match asked.ignore {
                    Ignore::Once => !asked.came,
                    Ignore::UntilApart => asked.came || asked.this_frame || rests >> i & 1 == 1,
                    Ignore::UntilRemoved => true,
                };
                (asked.this_frame, asked.came) = (false, false);
                stays && gone != NAMES[i].0 && gone != NAMES[i].1
            });
            let listed: Vec<_> = exceptions.iter().map(|(known, ignore)| (index(&known), ignore)).collect();
            let expected: Vec<_> = terms.iter().map(|(&i, asked)| (i, asked.ignore)).collect();
            assert_eq!(listed, expected, "M={M} {known:?} {code}");
            for i in 0..3 {
                let mut taken_back = exceptions;
                assert_eq!(taken_back.allow(pair(i, true).a, pair(i, true).b), terms.get(&i).map(|asked| asked.ignore));
                assert!(taken_back.passes(pair(i, false)));
            }
            match states.iter().find(|(same, _)| *same == exceptions) {
                Some((_, same)) => assert_eq!(format!("{same:?}"), format!("{terms:?}")),
                None => states.push((exceptions, terms)),
            }
        }
    }
    states.len()
}

#[test]
fn all_frames_of_all_exceptions() {
    assert_eq!(every_exception::<0>(), 1);
    assert_eq!(every_exception::<1>(), 1 + 3 * 3);
    assert_eq!(every_exception::<2>(), 1 + 3 * 3 + 3 * 9);
    assert_eq!(every_exception::<3>(), 64);
}

/// An ignored pair that had begun ends. It begins again once it counts again.
#[test]
fn exceptions_and_events() {
    let at = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 8, 8)).unwrap();
    let mut near = BruteForce::<4>::new();
    let (a, b) = (near.insert(&at(0), ()).unwrap(), near.insert(&at(4), ()).unwrap());
    let (mut events, mut exceptions) = (PairEvents::<4>::new(), Exceptions::<4>::new());
    let mut log = String::new();
    for frame in 0..8 {
        match frame {
            1 => exceptions.ignore(b, a, Ignore::Once).unwrap(),
            3 => exceptions.ignore(a, b, Ignore::UntilApart).unwrap(),
            5 => near.move_to(b, &at(9)).unwrap(),
            6 => near.move_to(b, &at(8)).unwrap(),
            7 => near.remove(b).unwrap(),
            _ => {}
        }
        near.pairs(|pair| {
            if exceptions.passes(pair) {
                events.feed(pair);
            }
        });
        events.finish(|_| false).unwrap();
        for event in events.iter() {
            assert_eq!(event.pair(), Pair { a, b });
            log.push(match event {
                PairEvent::Begin(_) => 'B',
                PairEvent::Stay(_) => 'S',
                PairEvent::End(_) => 'E',
            });
        }
        exceptions.finish(|handle| near.contains(handle), |_| false);
        log.push(' ');
    }
    assert_eq!(log, "B E B E   B E ");
}
