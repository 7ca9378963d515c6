//! The input level of a subcommand, and the options that define its solid. All subcommands share
//! these arguments and the project file.

use std::path::{Path, PathBuf};

use lexopt::Parser;
use tilesat::TileShape;

use super::args::{layer, once, text};
use crate::fail::{Fail, Result};
use crate::project::{self, scale, solid, weld};
use crate::read::Levels;
use crate::rules::options::Options;

/// The text about the level in the usage of each subcommand.
pub(crate) const LEVEL: &str = "
LEVEL is a map of Tiled (.tmx, .tmj; finite or infinite, in any encoding), a world of
its maps (.world), or a project of LDtk (.ldtk).
";

/// The text about the options.
pub(crate) const OPTIONS: &str = "
What is solid follows from the names of tiles, layers and objects: tilesat help rules
prints the rules a to d. These options come first:
  --solid NAME[=SHAPE]  tiles of this name are full, or of this shape
  --one-way NAME        tiles of this name are one-way from above
  --empty NAME          tiles of this name are empty
  --flag NAME           the name is only a flag; if there are more than eight
                        flags, the ones named here stay
  --solid-layer NAME    each tile of the layer is full, unless a or b gives its shape
  --one-way-layer NAME  the same, one-way from above; of shapes, the edges that face up
  --ignore-layer NAME   skip the layer
  --no-guess NAME       rule d makes nothing of the layer solid
  --objects NAME        the objects of the layer are solid
  --ignore-level NAME   skip the level of a project, which need not be readable
  --layer NAME          look for solids in this tile layer only
  --level NAME          take this level of a project (bake and lint: default all), and
                        decide about it alone
  --scale N/D           multiply all lengths by this
  --weld PX             move corners of tiles' collision shapes by up to this, from 0 to 1,
                        onto their tile's border and onto neighbours' corners (default: 0.25)
The NAME of a tile is its class, a true property, PROPERTY:VALUE, TILESET:ID, or an
IntGrid value (its identifier, its group, its number, or LAYER:NUMBER), in any case.
A file tilesat.toml beside the level sets the same for all levels there:
solid = [\"Grass\", \"Ramp=slope-bottom-left\"], one-way, empty, flag, solid-layer,
one-way-layer, ignore-layer, no-guess, objects, ignore-level (lists), scale = \"1/2\",
weld = \"0.25\".
";

/// A level file, and the user's options for it.
#[derive(Debug, Default)]
pub(crate) struct Input {
    pub(crate) level: Option<String>,
    pub(crate) options: Options,
}

impl Input {
    /// Reads an argument that all subcommands have. Returns `false` for other arguments.
    pub(crate) fn take(&mut self, name: &str, parser: &mut Parser) -> Result<bool> {
        let options = &mut self.options;
        match name {
            "solid" => options
                .shapes
                .push(solid(&text(parser, "--solid")?).map_err(|why| Fail::new(format!("--solid {why}")))?),
            "one-way" => options.shapes.push((text(parser, "--one-way")?, TileShape::OneWayUp)),
            "empty" => options.shapes.push((text(parser, "--empty")?, TileShape::Empty)),
            "flag" => options.flags.push(text(parser, "--flag")?),
            "solid-layer" => options.solid_layers.push(layer(parser, "--solid-layer")?),
            "one-way-layer" => options.one_way_layers.push(layer(parser, "--one-way-layer")?),
            "ignore-layer" => options.ignored_layers.push(layer(parser, "--ignore-layer")?),
            "no-guess" => options.unguessed_layers.push(layer(parser, "--no-guess")?),
            "objects" => options.objects.push(layer(parser, "--objects")?),
            "ignore-level" => options.ignored_levels.push(text(parser, "--ignore-level")?),
            "layer" => once(&mut options.layer, "--layer", text(parser, "--layer")?)?,
            "level" => once(&mut self.level, "--level", text(parser, "--level")?)?,
            "scale" => {
                let fraction = scale(&text(parser, "--scale")?).map_err(|why| Fail::new(format!("--scale {why}")))?;
                once(&mut options.scale, "--scale", fraction)?;
            }
            "weld" => {
                let most = weld(&text(parser, "--weld")?).map_err(|why| Fail::new(format!("--weld {why}")))?;
                once(&mut options.weld, "--weld", most)?;
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// The levels of a file, with the settings of the project file beside it.
    pub(crate) fn load(self, path: &Path) -> Result<(Levels, Options)> {
        project::load(path, self.level.as_deref(), self.options)
    }
}

/// The file that `LEVEL` names.
pub(crate) fn given(file: Option<PathBuf>) -> Result<PathBuf> {
    file.ok_or_else(|| Fail::new("no level given (see --help)"))
}
