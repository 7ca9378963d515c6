//! The contacts of a compound with a level: of each feature, that of the part that is deepest.

use super::closest::OneWay;
use super::contacts::kernel::{PushKernel, PushOne};
use super::contacts::{Pushable, WorldContact, is_listed, is_same};
use super::level::{Feature, World};
use crate::error::Truncated;
use crate::num::{Axis, Raw};
use crate::shape::{Aabb, Compound, Single};
use heapless::VecView;

impl<S: Single + PushOne, const M: usize> Pushable for Compound<S, M> {}

impl<S: Single + PushOne, const M: usize> PushKernel for Compound<S, M> {
    /// A feature goes into the list with its final depth, so a list that is full keeps the nearest
    /// of all. For that each part is asked first which of its contacts count.
    fn contacts_in<W: World>(
        &self,
        world: &W,
        one_way: OneWay,
        out: &mut VecView<WorldContact>,
    ) -> Result<u32, Truncated> {
        let (bounds, counts) = (self.aabb(), |f: &Feature| !(f.one_way && one_way == OneWay::Ignore));
        let (mut features, mut seen) = (0u32, 0u32);
        if !world.features(&bounds).any(|f| counts(&f)) {
            return Ok(0);
        }
        let sights: [Sight; M] = core::array::from_fn(|i| match self.parts().get(i) {
            Some(part) => Sight::of(part, world, counts, &mut features),
            None => Sight::NONE,
        });
        let mut surface = world.features(&bounds);
        while let Some(feature) = &surface.next() {
            features = features.wrapping_add(1);
            if !counts(feature) || is_listed(out, feature) {
                continue;
            }
            let all = self.parts().iter().zip(&sights);
            let met = all.filter_map(|(part, sight)| sight.meet::<W, S>(part, feature));
            if let Some(deepest) = met.max_by_key(|c| (c.depth(), order(c.axis()), c.point().raw())) {
                seen = seen.wrapping_add(1);
                deepest.insert_in::<W>(out);
            }
        }
        let kept = out.len() as u32;
        if kept == seen { Ok(features) } else { Err(Truncated { seen, kept }) }
    }

    fn centre(&self, part: usize) -> Option<Raw> {
        self.parts().get(part)?.centre(0)
    }
}

const fn order(axis: Axis) -> (u32, u32, i32, i32) {
    (axis.x.unsigned_abs(), axis.y.unsigned_abs(), axis.x, axis.y)
}

/// Which contacts of a part count.
struct Sight {
    /// Whether its middle is in the solid.
    behind: bool,
    /// Whether it is in the region of a feature. Other features do not count then.
    in_region: bool,
    /// Otherwise the one that counts, unless all do.
    spare: Option<WorldContact>,
}

impl Sight {
    const NONE: Self = Self { behind: false, in_region: false, spare: None };

    fn of<W: World, S: PushOne>(part: &S, world: &W, counts: impl Fn(&Feature) -> bool, features: &mut u32) -> Self {
        let mut sight = Self { behind: world.overlaps_aabb(&part.middle()), ..Self::NONE };
        let bounds: Aabb = part.bounds();
        let mut surface = world.features(&bounds);
        while let Some(feature) = surface.next() {
            *features = features.wrapping_add(1);
            if !counts(&feature) {
                continue;
            }
            let Some((contact, in_region)) = part.meet::<W>(&feature, sight.behind && !feature.one_way) else {
                continue;
            };
            if in_region {
                return Self { in_region, spare: None, ..sight };
            }
            let new = WorldContact::new(contact, feature);
            if !S::ROUND && sight.spare.as_ref().is_none_or(|spare| new.goes_before::<W>(spare, S::BY_DEPTH)) {
                sight.spare = Some(new);
            }
        }
        sight
    }

    fn meet<W: World, S: PushOne>(&self, part: &S, feature: &Feature) -> Option<WorldContact> {
        let (contact, in_region) = part.meet::<W>(feature, self.behind && !feature.one_way)?;
        let is_spare = S::ROUND || self.spare.as_ref().is_some_and(|spare| is_same(&spare.feature(), feature));
        (in_region || (!self.in_region && is_spare)).then(|| WorldContact::new(contact, *feature))
    }
}
