//! Colours.

/// A colour and its opacity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ink {
    pub rgb: [u8; 3],
    /// 0 is invisible, 1 hides everything below.
    pub alpha: f32,
}

impl Ink {
    const fn hex(rgb: u32) -> Self {
        Self { rgb: [(rgb >> 16) as u8, (rgb >> 8) as u8, rgb as u8], alpha: 1.0 }
    }

    /// The same colour with this opacity.
    #[must_use]
    pub const fn alpha(self, alpha: f32) -> Self {
        Self { alpha, ..self }
    }
}

pub const NIGHT: Ink = Ink::hex(0x0014_1926);
pub const NIGHT_LOW: Ink = Ink::hex(0x0022_2c42);
pub const PAPER: Ink = Ink::hex(0x000d_111a);
pub const TEXT: Ink = Ink::hex(0x00c9_d3e6);
pub const FAINT: Ink = Ink::hex(0x0078_859e);
pub const EARTH: Ink = Ink::hex(0x0039_4560);
pub const EARTH_DARK: Ink = Ink::hex(0x0030_3a52);
pub const EDGE: Ink = Ink::hex(0x007f_93bd);
pub const TOP: Ink = Ink::hex(0x0074_c69d);
pub const PLANK: Ink = Ink::hex(0x00d4_a373);
pub const COIN: Ink = Ink::hex(0x00ff_d23f);
pub const KILL: Ink = Ink::hex(0x00ef_476f);
pub const WIN: Ink = Ink::hex(0x0006_d6a0);
pub const WATER: Ink = Ink::hex(0x003a_86ff);
pub const LADDER: Ink = Ink::hex(0x00b0_8968);
pub const PLAYER: Ink = Ink::hex(0x00ff_e8a3);
pub const SLIDE: Ink = Ink::hex(0x004c_c9f0);
pub const TOUCH: Ink = Ink::hex(0x00f9_8d5f);
pub const CROSS: Ink = Ink::hex(0x00b8_92ff);
pub const BOUNCE: Ink = Ink::hex(0x0090_ee90);
pub const CONTACT: Ink = Ink::hex(0x00ff_ffff);
/// For flags without a meaning in the game.
pub const OTHER: [Ink; 4] =
    [Ink::hex(0x0057_75ab), Ink::hex(0x0090_5f9e), Ink::hex(0x0043_aa8b), Ink::hex(0x00a8_7b43)];
