//! Rows of work that continues from frame to frame: moving bodies and broad phases. Every backend
//! must give the host's answers.

use crate::inputs::{Class, Reader};
use crate::table::{Key, Mean, Query, Table};
use core::mem::MaybeUninit;
use tilesat_counts::clock::Clock;
use tilesat_precision_queries::{Area, Exact, Phase, Place, Raw, Room, Scene, Shape, Step};
use tilesat_textbook::checksum::{START, mixed, pair};

/// The level of a workload, whose first corner is the class's.
///
/// # Panics
/// If the host's file does not mention it.
pub fn room(levels: &'static [u8], class: &Class) -> Room {
    let mut r = Reader::new(levels);
    loop {
        let name = r.text();
        let [width, height, cell] = r.words();
        let tiles = core::array::from_fn(|_| r.words());
        let cells = r.bytes((width * height) as usize);
        if name == class.workload {
            let origin = class.about.clone().word();
            return Room { cells, width: width as u16, height: height as u16, cell, origin, tiles };
        }
    }
}

/// Two words per motion, after the body's.
fn motions(class: &Class) -> usize {
    (class.width - 4) / 2
}

/// Memory of a frame's calls, on the smallest board.
const STACK: usize = 1 << 10;

impl<C: Clock> Table<C> {
    /// The row of a class. Each body continues from its last position.
    #[inline(never)]
    pub fn moves<'a, L, B, V>(&mut self, key: Key, class: &Class, level: &'a L, query: Query<Step<'a, L, B, V>, B>)
    where
        B: Shape + Exact + Copy,
        V: Place,
    {
        let (mut mean, mut sum) = (Mean::default(), START);
        for mut record in class.records() {
            let start: Raw = record.words();
            let mut body = B::of(&start);
            for _ in 0..motions(class) {
                let step = Step::of(level, &body, record.words().into());
                let mut out = MaybeUninit::uninit();
                mean.add(self.count(query, &step, &mut out));
                // SAFETY: a query always stores its answer.
                body = unsafe { out.assume_init() };
                sum = mixed(sum, &body.exact());
            }
        }
        self.finish(key, class, &mean, sum);
    }

    /// The row of a class: frames of boxes. The first frame does not count.
    #[inline(never)]
    pub fn broad<P: Phase<N>, const N: usize>(&mut self, key: Key, class: &Class) {
        const {
            let held = size_of::<Scene<P, N>>() + size_of::<[P::Box; N]>();
            assert!(cfg!(large) || held + STACK <= 16 << 10, "a micro:bit holds them");
        }
        let (mut mean, mut sum) = (Mean::default(), 0_u32);
        let [origin, columns] = class.about.clone().words();
        let area = Area { origin, columns: columns as u16 };
        let Some(mut first) = class.records().next() else { return };
        let mut boxes: [P::Box; N] = core::array::from_fn(|_| P::Box::of(&first.words()));
        let mut scene = Scene::<P, N>::start(&boxes, area);
        for (frame, mut record) in class.records().enumerate() {
            boxes.fill_with(|| P::Box::of(&record.words()));
            let n = self.count(|boxes, scene: &mut Scene<P, N>| scene.frame(boxes), &boxes, &mut scene);
            if frame > 0 {
                mean.add(n);
            }
            sum = scene.pairs().iter().fold(sum, |sum, &(a, b)| sum.wrapping_add(pair(frame, (a.into(), b.into()))));
        }
        self.finish(key, class, &mean, sum);
    }

    fn finish(&mut self, key: Key, class: &Class, mean: &Mean, sum: u32) {
        self.print(key, class.name, [mean, &Mean::default(), &Mean::default()]);
        if class.answer(key.1, key.2) != Some(sum) {
            self.refuse(key, class.name);
        }
    }
}
