//! What the identifier of an `LDtk` value means: the name of a shape, then the names of flags, joined by
//! underscores: `Full`, `SlopeTopLeft_Ice`, `slope_top_left`, `Empty_Coin`.

use tilesat::TileShape;

use super::traits::Traits;

type Result<T> = std::result::Result<T, String>;

/// The shape and the flags in an identifier: as many words as name a shape, then flags.
pub(crate) fn meaning(identifier: &str) -> Result<Traits> {
    let words: Vec<&str> = identifier.split('_').collect();
    for count in (1..=words.len()).rev() {
        let (name, flags) = words.split_at(count);
        if let Some(shape) = shape(&name.concat()) {
            let flags = Traits::from_names(flags).flags;
            return Ok(Traits { shape, flags });
        }
    }
    Err(format!("'{identifier}' does not begin with the name of a shape; 'Empty_{identifier}' would be a flag alone"))
}

/// The shape of this name in the library, `Solid` and `OneWay`, without regard to case.
fn shape(name: &str) -> Option<TileShape> {
    let plain = |shape: &TileShape| name.eq_ignore_ascii_case(&format!("{shape:?}"));
    let short = Traits::from_names(&[name]).shape;
    TileShape::ALL.into_iter().find(plain).or((short != TileShape::Empty).then_some(short))
}
