//! Fractions and ratios: at most one.

use super::{Ratio, Toi};
use crate::stored::{StoredForm, stored};
use serde::{Deserialize, Serialize};

/// In parts of 2^30.
#[derive(Serialize, Deserialize)]
struct Parts(u32);

const ABOVE_ONE: &str = "it is above one, which is 2^30 parts";

impl StoredForm<Toi> for Parts {
    type Fault = &'static str;

    fn of(toi: &Toi) -> Self {
        Self(toi.raw())
    }

    fn check(self) -> Result<Toi, Self::Fault> {
        Toi::from_raw(self.0).ok_or(ABOVE_ONE)
    }
}

impl StoredForm<Ratio> for Parts {
    type Fault = &'static str;

    fn of(ratio: &Ratio) -> Self {
        Self(ratio.raw())
    }

    fn check(self) -> Result<Ratio, Self::Fault> {
        Ratio::from_raw(self.0).ok_or(ABOVE_ONE)
    }
}

stored!(Toi as Parts);
stored!(Ratio as Parts);
