//! Filters: their flags by name.

use super::{Filter, LayerMask};
use crate::stored::{StoredForm, stored};
use core::convert::Infallible;
use serde::{Deserialize, Serialize};

#[derive(Serialize, Deserialize)]
struct FilterFields {
    layers: LayerMask,
    mask: LayerMask,
    group: i16,
    still: bool,
    sensor: bool,
}

impl StoredForm<Filter> for FilterFields {
    type Fault = Infallible;

    fn of(filter: &Filter) -> Self {
        let Filter { layers, mask, group, .. } = *filter;
        Self { layers, mask, group, still: filter.still(), sensor: filter.sensor() }
    }

    fn check(self) -> Result<Filter, Infallible> {
        let filter = Filter::new(self.layers, self.mask).with_group(self.group);
        Ok(filter.with_still(self.still).with_sensor(self.sensor))
    }
}

stored!(Filter as FilterFields);
