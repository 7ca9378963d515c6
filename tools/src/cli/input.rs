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
A tile is solid by the first of these rules that applies:
  a  its class or a true property: Collision, Solid, Collide, Collides, Collidable,
     Collider, Wall, Blocked; words for one-way; or a property shape (full, one-way-up,
     slope-bottom-left, .., as tilesat sheet draws them) or npp (its number in N++,
     0 to 33). If it also has shapes of rule b, they are the solid, or their edges that
     face up if it is one-way
  b  its shapes of Tiled's collision editor, but not those that a class or a true
     property calls sensor or trigger, nor those in a layer named coin, gem or pickup
  c  its layer has a name, class or true property with the word collision, collider,
     collide, collidable, solid, blocked or blocking: every tile drawn there is full;
     with words for one-way: every tile drawn there is one-way from above, or the edges
     of its shapes that face up. Values of an LDtk IntGrid with such a name, too, except
     values named water, ladder, spikes, background and the like
  d  if no tile is solid so far: its class or a true property has a word of c
     or is impassable, or its property walkable or passable is false (properties such as
     collideUp name sides: all four are full, one is one-way); if still no tile is solid:
     its layer is named wall, ground, terrain, platform, block, obstacle or physics; if
     still none is: floor, boundary or barrier; then collision, wall, platform and
     ground in German, French, Spanish, Portuguese, Russian, Chinese or Japanese. Ground
     that is nearly everywhere, and on which such walls stand, is not solid, nor is ground
     beside a layer of solid objects, nor any layer on which the solid objects lie, nor
     one with a word such as background, bg, deco or fake. Values of an LDtk IntGrid
     follow these words too, also dirt, stone, rock, brick, earth, and names of shapes,
     with flags: SlopeTopLeft_Ice. If the name of a value says nothing, that of its group
     counts. Other values without an identifier follow the rules c and d of their layer
Words for one-way are one way, semi solid, solid top, jump through, jump thru, pass
through and drop through, in any case, together or apart: OneWayPlatform, semi-solid.
One way says more than solid. Rule d looks for objects in the same way, with the names
of their layers; if tiles are solid, only objects without a name, a class, properties
and a picture count. If still nothing is solid, the classes and names of objects count,
such as CollisionBox or Ground. Words can have an end such as layer, map, tile, object or
box without a blank: collisionlayer. One-way finds do not end the search. All levels of a file are
decided together. A note names each guess, and each layer that a guess would have made
solid.
What a tile, an object or a layer denies (its property solid or collides is false) is not
solid by b, c and d. By a it is, with a warning: its class or other property counts. But
what an object itself denies counts more than the marks of its template and its tile. Nor is a tile that is walkable, by c and d. A sensor or a trigger is
not solid by a, either, nor is a tile in a layer that denies it. A group says it for its
layers; of a layer and the groups around it, the nearest that says something counts.
All other classes and true properties are flags: the first eight, from the lowest layer
up. These options come first:
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
IntGrid value (its identifier, its group, its number, or LAYER:NUMBER), in any case. A file
tilesat.toml beside the level sets the same for all levels there: solid = [\"Grass\", \"Ramp=slope-bottom-left\"],
one-way, empty, flag, solid-layer, one-way-layer, ignore-layer, no-guess, objects, ignore-level
(lists), scale = \"1/2\", weld = \"0.25\".
Objects are solid if --objects, their class, a true property, a true LDtk field, their
name, a property type, class or name with such a word as its value, or their layer
(rule c, or the name Walls) says so: rectangles, polygons and ellipses within, and
polylines as walls. One-way forms block from above: closed ones with the edges that face
up, and lines in any direction, except steep ones, which block from the left of their
way. A hole is cut out of the solid polygon around it; without one it is for the game.
The property kind chooses solid, hole, wall (a chain that blocks from both sides) or
one-way.
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
