//! Finds the solid objects: those whose own names or whose layer makes them solid.

use super::form::{self, Corners};
use super::kind::Kind;
use super::marked;
use super::options::{Options, listed};
use super::outline::{LeftOut, Outline, Title};
use super::piece::{self, Path};
use super::place::Unit;
use super::words::{self, COLLISION};
use super::{edges, flat, left_out, stamps, traits};
use crate::model::decimal::Decimal;
use crate::model::map::{Layer, Map};
use crate::model::object::{Form, Object};
use crate::model::property::Value;
use tilesat::TileShape;

/// A layer's setting for its objects: a kind, or that they are solid as drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Says {
    Kind(Kind),
    Solid,
    Nothing,
}

/// The settings in the names of a layer of objects.
pub(super) fn layer_says(layer: &Layer, options: &Options) -> Says {
    let own: Vec<&str> = [&layer.name, &layer.class].into_iter().chain(&layer.marks).map(String::as_str).collect();
    if listed(&options.one_way_layers, &layer.name) {
        return Says::Kind(Kind::OneWay);
    }
    if marked::denial(layer).is_some() && !by_option(layer, options) {
        return Says::Nothing;
    }
    let around = layer.around();
    let kinds = || own.iter().copied().filter_map(Kind::from_name);
    if kinds().any(|kind| kind == Kind::Hole) {
        return Says::Kind(Kind::Hole);
    }
    if own.iter().copied().chain(around.clone()).any(words::is_one_way) {
        return Says::Kind(Kind::OneWay);
    }
    // In a layer called `Walls`, each object gets the kind that suits its form.
    let says = |name: &str| words::has(name, COLLISION) || traits::shape(name) == Some(TileShape::Full);
    if by_option(layer, options) || own.iter().copied().chain(around).any(says) { Says::Solid } else { Says::Nothing }
}

/// Whether the user says that the objects of a layer are solid.
fn by_option(layer: &Layer, options: &Options) -> bool {
    let lists = [&options.objects, &options.solid_layers, &options.one_way_layers];
    lists.into_iter().any(|list| listed(list, &layer.name))
}

/// An outline of an object.
pub(super) struct Drawn {
    pub(super) outline: Outline,
    /// How far it lies within a round form at most, in thousandths of a pixel.
    pub(super) error: u32,
    /// Whether it is a part of a polygon that crosses itself.
    pub(super) torn: bool,
}

/// The outlines of an object, or the reason that there is none.
pub(super) fn outlines(
    map: &Map,
    object: &Object,
    layer: &Layer,
    says: Says,
    unit: Unit,
    options: &Options,
) -> Result<Result<Vec<Drawn>, LeftOut>, String> {
    let title = Title { id: object.id, name: object.name.clone(), layer: layer.name.clone() };
    let out = |why: String| left_out::of(object, layer, unit, why);
    let left_out = |why: String| Ok(Err(out(why)));
    let Some(corners) = form::enlarged(object, unit.zoom()) else {
        return left_out(if object.form == Form::Text { "it is a text" } else { "it is a point" }.to_owned());
    };
    if !form::has_extent(object) {
        return left_out("it has no size, so it is a point".to_owned());
    }
    let shapes = match &object.form {
        Form::Tile(stamp) => stamps::shapes(&map.tilesets[stamp.tileset], stamp, object.size, unit.zoom()),
        _ => Ok(Vec::new()),
    };
    let is_tile = matches!(object.form, Form::Tile(_));
    let flat = object.size.0 == Decimal::ZERO || object.size.1 == Decimal::ZERO;
    // What an object says of itself counts more than its layer, and less than the user.
    let of_layer = by_option(layer, options);
    let own = [&object.properties, &object.fields];
    let denied = own.into_iter().find_map(marked::denied).filter(|_| !of_layer);
    let by_user = || of_layer || options.shape(&names(object).map(str::to_owned).collect::<Vec<_>>()).is_some();
    if marked::senses(&object.class, &object.properties) && !by_user() {
        return left_out("it is a sensor or a trigger".to_owned());
    }
    if let Some(name) = overridden(object, options)?.filter(|_| !by_user()) {
        return left_out(format!("its property '{name}' is false"));
    }
    let kind = match kind(object, if denied.is_some() { Says::Nothing } else { says }, options)? {
        // A tile has an inside.
        Some(Kind::Wall) if is_tile => Kind::Solid,
        Some(kind) if !is_tile || !flat => kind,
        _ if is_tile => return left_out(of_tile(shapes.map_or(1, |shapes| shapes.len()), &layer.name)),
        _ => {
            let class = if object.class.is_empty() { &layer.class } else { &object.class };
            let why = if let (Some(name), Says::Kind(_) | Says::Solid) = (denied, says) {
                format!("its property '{name}' is false")
            } else if class.is_empty() {
                "nothing says that it is solid".to_owned()
            } else {
                format!("its class '{class}' is for the game")
            };
            return left_out(why);
        }
    };
    let shapes = shapes.map_err(|why| format!("object {}: {why}", object.id))?;
    let outline = |(kind, corners, torn): Formed| {
        let (title, flags, points, rounding) = (title.clone(), flags(object, options), Vec::new(), Vec::new());
        let mut outline = Outline { title, kind, closed: corners.closed, points, rounding, flags };
        for (x, y) in corners.points {
            let ((x, off_x), (y, off_y)) = (unit.raw(x + layer.offset.0), unit.raw(y + layer.offset.1));
            outline.points.push((x, y));
            outline.rounding.push(off_x.max(off_y));
        }
        Drawn { outline, error: corners.error, torn }
    };
    let is_far = corners.points.iter().any(|(x, y)| x.is_far() || y.is_far());
    if is_far && options.rooms {
        return Err(format!("object {}: it is a million pixels away or wide: move it, or make it smaller", object.id));
    }
    let drawn: Vec<Drawn> = formed(map, object, kind, corners, shapes).into_iter().map(outline).collect();
    // Numbers end a million pixels away. What is there has lost its form, and is refused.
    let why =
        |drawn: &Drawn| flat::why(drawn.outline.kind, drawn.outline.closed, &drawn.outline.points).filter(|_| !is_far);
    match &drawn[..] {
        [only] => match why(only) {
            Some(why) => Ok(Err(LeftOut { suspicious: true, ..out(why) })),
            None => Ok(Ok(drawn)),
        },
        _ => Ok(Ok(drawn.into_iter().filter(|drawn| why(drawn).is_none()).collect())),
    }
}

/// A kind, its corners, and whether it is a part of a polygon that crosses itself.
type Formed = (Kind, Corners, bool);

/// The forms of a solid object. A solid tile has the shapes of Tiled's collision editor, if it has
/// some. What is one-way has each chain of its edges that face up.
fn formed(map: &Map, object: &Object, kind: Kind, mut corners: Corners, shapes: Vec<Path>) -> Vec<Formed> {
    if let Form::Tile(stamp) = &object.form {
        if !shapes.is_empty() && kind != Kind::Hole {
            let placed = |path: Path| {
                let points = form::of_picture(object, stamp, &path.points);
                Path { points, ..path }
            };
            let mut paths: Vec<Path> = shapes.into_iter().map(placed).collect();
            if kind == Kind::OneWay {
                paths = piece::one_way(paths, TileShape::OneWayUp);
            }
            let formed = |path: Path| {
                (path.kind, Corners { points: path.points, closed: path.closed, error: path.error }, path.torn)
            };
            return paths.into_iter().map(formed).collect();
        }
        // The picture can be smaller than the object.
        let ((x, y), (right, bottom)) = stamps::picture(&map.tilesets[stamp.tileset], stamp, object.size);
        corners.points = form::of_picture(object, stamp, &[(x, y), (right, y), (right, bottom), (x, bottom)]);
    }
    let chains = match (kind, corners.closed) {
        (Kind::OneWay, true) => edges::facing(&corners.points, TileShape::OneWayUp),
        (Kind::OneWay, false) => {
            edges::upward(&mut corners.points);
            Vec::new()
        }
        _ => Vec::new(),
    };
    // A vertical line has no edge that faces up.
    if chains.is_empty() {
        return vec![(kind, corners, false)];
    }
    let chain = |points| (kind, Corners { points, closed: false, error: corners.error }, false);
    chains.into_iter().map(chain).collect()
}

/// Why a tile as an object is not solid, and what makes it so. Many are things of the game with a
/// picture, so its collision shapes alone do not.
fn of_tile(shapes: usize, layer: &str) -> String {
    let what = match shapes {
        0 => return "it is a tile as an object, and nothing says that it is solid".to_owned(),
        1 => "whose tile has a collision shape".to_owned(),
        _ => format!("whose tile has {shapes} collision shapes"),
    };
    format!(
        "it is a tile as an object, {what}, but nothing says that it is solid; give it the class Solid, or add --objects '{layer}'"
    )
}

/// The kind of an object: from its property `kind`, its names, or its layer. Without a name, from
/// its form.
pub(super) fn kind(object: &Object, says: Says, options: &Options) -> Result<Option<Kind>, String> {
    let whose = format!("object {}", object.id);
    let by_form = if matches!(object.form, Form::Polyline(_)) { Kind::Wall } else { Kind::Solid };
    let given = object.properties.text("kind");
    if let Some(kind) = given.as_deref().and_then(Kind::from_name) {
        return Ok(Some(kind));
    }
    let own: Vec<String> = names(object).map(str::to_owned).collect();
    match options.shape(&known(object)) {
        Some((_, TileShape::Empty)) => return Ok(None),
        Some((_, shape)) => return Ok(Some(if super::names::is_one_way(shape) { Kind::OneWay } else { by_form })),
        None => {}
    }
    let is_name = |name: &&String| !options.is_flag(name);
    let kinds: Vec<(Kind, &String)> =
        own.iter().filter(is_name).filter_map(|name| Some((Kind::from_name(name)?, name))).collect();
    if let Some((hole, other)) = contrary(&kinds) {
        let class = object.class.trim();
        let of = |name: &String| {
            let what = if name == class { "class" } else { "property" };
            format!("{what} '{name}'")
        };
        return Err(format!("{whose} is both solid and hole: remove its {} or its {}", of(hole), of(other)));
    }
    // One way says more than solid. A wall is solid, unless it is a line.
    let fitting = |kind: Kind| if matches!(kind, Kind::Wall | Kind::Solid) { by_form } else { kind };
    let one_way = kinds.iter().map(|(kind, _)| *kind).find(|kind| *kind == Kind::OneWay);
    let own_kind = one_way.or_else(|| kinds.first().map(|(kind, _)| *kind));
    let by_name = || Kind::from_name(&object.name);
    let kind = own_kind.or_else(by_name).or_else(|| written(object)).map(fitting).or(match says {
        Says::Kind(kind) => Some(kind),
        Says::Solid => Some(by_form),
        Says::Nothing => None,
    });
    // Games use the word for something else, but a solid has one of ours.
    if let (Some(kind), Some(name)) = (kind, given) {
        let known = "the kinds are solid, hole, wall and one-way";
        return Err(format!(
            "{whose} has the kind '{name}'; {known}, and it is {kind} by its layer or its other names"
        ));
    }
    Ok(kind)
}

/// The property by which an object itself denies what its template, its tile or its class makes it.
/// Nothing else is nearer.
fn overridden(object: &Object, options: &Options) -> Result<Option<String>, String> {
    if marked::denied(&object.properties).is_none() {
        return Ok(None);
    }
    let itself = object.itself();
    let marked = |object: &Object| Ok::<_, String>(kind(object, Says::Nothing, options)?.is_some());
    let denied = marked::denied(&itself.properties).map(str::to_owned);
    Ok(if marked(object)? && !marked(&itself)? { denied } else { None })
}

/// The property by which an object denies that it is solid, if it is solid all the same by its own
/// marks.
pub(super) fn contradicted(object: &Object, layer: &Layer, options: &Options) -> Result<Option<String>, String> {
    let Some(denied) = [&object.properties, &object.fields].into_iter().find_map(marked::denied) else {
        return Ok(None);
    };
    let by_user = || by_option(layer, options) || options.shape(&known(object)).is_some();
    let solid = kind(object, Says::Nothing, options)?.is_some_and(Kind::is_solid) && form::has_extent(object);
    let counts = solid && !marked::senses(&object.class, &object.properties) && !by_user();
    Ok(if counts && overridden(object, options)?.is_none() { Some(denied.to_owned()) } else { None })
}

/// The names of a hole and of something else, if an object has both.
fn contrary<'a>(kinds: &[(Kind, &'a String)]) -> Option<(&'a String, &'a String)> {
    let first = |is_hole: bool| kinds.iter().find(|(kind, _)| (*kind == Kind::Hole) == is_hole).map(|(_, name)| *name);
    first(true).zip(first(false))
}

/// The kind that a property with a class or a name in it gives: some engines read properties only.
/// Other words than those of barriers mean something else in many games, such as golf.
fn written(object: &Object) -> Option<Kind> {
    let values = ["type", "class", "name"].into_iter().filter_map(|name| object.properties.text(name));
    let kinds = values.filter_map(|value| Kind::from_name(&value));
    kinds.into_iter().find(|kind| *kind != Kind::Hole)
}

/// A note about values of the property `kind` that are no kinds of solids.
pub(super) fn other_kinds(objects: &[LeftOut]) -> Option<String> {
    let mut kinds = objects.iter().filter_map(|object| object.properties.text("kind"));
    let first = kinds.next()?;
    let count = words::several(1 + kinds.count(), "object");
    Some(format!("{count} with the property kind, such as '{first}': no kind of a solid, so it is for the game"))
}

/// The class, the true properties, and the true fields of an `LDtk` entity that have a word of the
/// rules. Others are for the game.
fn names(object: &Object) -> impl Iterator<Item = &str> {
    let fields =
        object.fields.0.iter().filter(|(name, value)| *value == Value::Bool(true) && traits::shape(name).is_some());
    let fields = fields.map(|(name, _)| name.as_str());
    let own = [object.class.as_str()].into_iter().chain(object.properties.marks()).chain(fields);
    own.map(str::trim).filter(|name| !name.is_empty())
}

/// Its names, and its other properties with their values, by which an option knows it.
fn known(object: &Object) -> Vec<String> {
    names(object).map(str::to_owned).chain(object.properties.valued()).collect()
}

fn flags(object: &Object, options: &Options) -> Vec<String> {
    let mut flags: Vec<String> = Vec::new();
    for name in names(object).filter(|name| options.is_flag(name) || Kind::from_name(name).is_none()) {
        let given = !options.is_flag(name) && options.shape(&[name.to_owned()]).is_some();
        if !given && !flags.iter().any(|f| f.eq_ignore_ascii_case(name)) {
            flags.push(name.to_owned());
        }
    }
    flags
}
