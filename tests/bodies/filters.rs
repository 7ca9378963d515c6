//! Filters: the whole truth table of two layers, each layer by itself, and the meaning of the
//! words.

use tilesat::broad::Tag;
use tilesat::{Filter, LayerMask};

/// The documentation's sentences as code.
#[derive(Clone, Copy, Debug)]
struct Plain {
    layers: [bool; 2],
    mask: [bool; 2],
    group: i16,
    still: bool,
    sensor: bool,
}

impl Plain {
    fn all() -> Vec<Self> {
        let bits = |n: u32, from: u32| [n >> from & 1 == 1, n >> (from + 1) & 1 == 1];
        let groups = [0, 1, 2, i16::MAX, -1, i16::MIN];
        let words = (0..64).flat_map(|n| groups.map(|group| (n, group)));
        words
            .map(|(n, group)| {
                let [still, sensor] = bits(n, 4);
                Self { layers: bits(n, 0), mask: bits(n, 2), group, still, sensor }
            })
            .collect()
    }

    /// The two layers as the lowest, the highest, or a low and a high one.
    fn filter(self, places: [u8; 2]) -> Filter {
        let set = |on: [bool; 2]| {
            let part = |i: usize| if on[i] { LayerMask::layer(places[i]) } else { LayerMask::NONE };
            part(0) | part(1)
        };
        let filter = Filter::new(set(self.layers), set(self.mask)).with_group(self.group);
        filter.with_sensor(self.sensor).with_still(self.still)
    }

    fn pairs_with(self, other: Self) -> bool {
        let both_still = self.still && other.still;
        let both_sensors = self.sensor && other.sensor;
        if both_still || both_sensors {
            return false;
        }
        if self.group != 0 && self.group == other.group {
            return self.group > 0;
        }
        let sees = |a: Self, b: Self| (a.mask[0] && b.layers[0]) || (a.mask[1] && b.layers[1]);
        sees(self, other) && sees(other, self)
    }
}

#[test]
fn the_whole_table() {
    let all = Plain::all();
    let mut paired = 0;
    for places in [[0, 1], [14, 15], [3, 15], [0, 8]] {
        let filters: Vec<Filter> = all.iter().map(|plain| plain.filter(places)).collect();
        for (a, plain_a) in filters.iter().zip(&all) {
            for (b, plain_b) in filters.iter().zip(&all) {
                let expected = plain_a.pairs_with(*plain_b);
                assert_eq!(a.pairs_with(b), expected, "{plain_a:?} {plain_b:?}");
                assert_eq!(b.pairs_with(a), expected);
                assert!(!(a.still() && b.still() && expected), "what does not move never pairs");
                paired += u32::from(expected);
            }
        }
    }
    // Of 36 pairs of groups, 3 pair always, 2 never, and 31 as masks decide. 7 of 16 combinations
    // of layers and masks meet, each way. Flags agree in 9 of 16.
    assert_eq!(paired, 4 * 9 * (3 * 256 + 31 * 7 * 7));
}

#[test]
fn each_layer_by_itself() {
    for i in 0..16 {
        for j in 0..16 {
            let (one, other) = (LayerMask::layer(i), LayerMask::layer(j));
            assert!(Filter::new(one, other).pairs_with(&Filter::new(other, one)));
            assert_eq!(Filter::new(one, other).pairs_with(&Filter::new(one, other)), i == j);
            assert_eq!(Filter::new(one, LayerMask::ALL).pairs_with(&Filter::new(LayerMask::ALL, !other)), i != j);
        }
    }
    assert_eq!(LayerMask::layer(16), LayerMask::layer(0));
}

#[test]
fn words_do_not_disturb_each_other() {
    for plain in Plain::all() {
        let filter = plain.filter([0, 15]);
        let (still, sensor) = (filter.still(), filter.sensor());
        assert_eq!((still, sensor), (plain.still, plain.sensor));
        let turned = filter.with_still(!still);
        assert_eq!((turned.still(), turned.sensor(), turned.group), (!still, sensor, plain.group));
        assert_eq!((turned.layers, turned.mask), (filter.layers, filter.mask));
        assert_eq!(turned.with_still(still), filter);
        assert_eq!(filter.with_sensor(!sensor).with_sensor(sensor), filter);
        assert_eq!(filter.with_group(7).with_group(plain.group), filter);
    }
    let blank = <Filter as Tag>::BLANK;
    assert!(!blank.pairs_with(&blank) && !blank.pairs_with(&Filter::default()));
}
