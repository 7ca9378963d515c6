//! The rules that say what is solid, as `tilesat help rules` prints them. The options that come
//! before them are in the help of each command.

pub(super) const RULES: &str = "\
A tile is solid by the first of these rules that applies. The options of a command, such
as --solid NAME, come before all of them.
  a  its class or a true property: Collision, Solid, Collide, Collides, Collidable,
     Collider, Wall, Blocked; words for one-way; or a property shape (full, one-way-up,
     slope-bottom-left, .., as tilesat sheet draws them) or npp (its number in N++,
     0 to 33). If it also has shapes of rule b, they are the solid, or their edges that
     face up if it is one-way
  b  its shapes of Tiled's collision editor, but not those that a class or a true
     property calls sensor or trigger, nor those in a layer named coin, gem or pickup.
     A tile with only sensors counts as one without shapes: a and c make it full
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
box without a blank: collisionlayer. One-way finds do not end the search. All levels of a
file are decided together. A note names each guess, and each layer that a guess would
have made solid.

What a tile, an object or a layer denies (its property solid or collides is false) is not
solid by b, c and d. By a it is, with a warning: its class or other property counts. But
what an object itself denies counts more than the marks of its template and its tile. Nor
is a tile that is walkable, by c and d. A tile that is a sensor or a trigger is not solid
by a, either, nor is a tile in a layer that denies it. A group says it for its layers; of a
layer and the groups around it, the nearest that says something counts.
All other classes and true properties are flags: the first eight, from the lowest layer
up.

Objects are solid if --objects, their class, a true property, a true LDtk field, their
name, a property type, class or name with such a word as its value, or their layer
(rule c, or the name Walls) says so: rectangles, polygons and ellipses within, and
polylines as walls. One-way forms block from above: closed ones with the edges that face
up, and lines in any direction, except steep ones, which block from the left of their
way. A hole is cut out of the solid polygon around it; without one it is for the game.
The property kind chooses solid, hole, wall (a chain that blocks from both sides) or
one-way.
";
