//! Levels with one mistake each, and the linter's lines about them.

/// A name, a level of objects, options, and the lines.
pub(crate) type Case = (&'static str, &'static str, &'static str, &'static [&'static str]);

pub(crate) const CASES: &[Case] = &[
    (
        "zero-length",
        r#"<object id="3" x="0" y="0"><polygon points="0,0 32,0 32,0 0,32"/></object>"#,
        "",
        &[
            "error zero-length at (32, 0): object 3 of layer 'L', edge 1: no length; an edge without a direction has no normal",
        ],
    ),
    (
        "short",
        r#"<object id="3" x="0" y="0"><polygon points="0,0 32,0 32,0.5 0,32"/></object>"#,
        "",
        &[
            "warning sliver at (32, 0): object 3 of layer 'L', edge 1: 0.5 long; a body may catch on it: move its two corners onto one point",
        ],
    ),
    (
        "thin",
        r#"<object id="3" name="lid" x="8" y="8" width="64" height="3"/>"#,
        "--small 4",
        &[
            "warning sliver at (8, 8): object 3 'lid' of layer 'L': on average only 3 thick; a body meets two of its faces at once",
            "warning sliver at (72, 8): object 3 'lid' of layer 'L', edge 1: 3 long; a body may catch on it: move its two corners onto one point",
            "warning sliver at (8, 11): object 3 'lid' of layer 'L', edge 3: 3 long; a body may catch on it: move its two corners onto one point",
        ],
    ),
    (
        "acute",
        r#"<object id="3" x="0" y="0"><polygon points="0,0 64,0 64,7"/></object>"#,
        "",
        &[
            "warning sliver at (0, 0): object 3 of layer 'L', edge 0: an angle of less than 7 degrees where this edge begins; bodies get wedged in it or catch on it",
        ],
    ),
    ("not_so_acute", r#"<object id="3" x="0" y="0"><polygon points="0,0 64,0 64,9"/></object>"#, "", &[]),
    (
        "flat",
        r#"<object id="3" x="0" y="0"><polygon points="0,0 64,0 32,0"/></object><object id="4" x="0" y="16" width="64" height="64"/>"#,
        "",
        &[
            "warning left-out at (0, 0): object 3 of layer 'L': its height is 0, so it is not solid: give it one, or draw a polyline, which is a wall; nothing collides with it",
        ],
    ),
    (
        "two_points",
        r#"<object id="3" x="0" y="0"><polygon points="0,0 64,0"/></object><object id="4" x="0" y="16" width="64" height="64"/>"#,
        "",
        &[
            "warning left-out at (0, 0): object 3 of layer 'L': it has 2 corners, so it is not solid: draw a third one; nothing collides with it",
        ],
    ),
    (
        "no_area",
        r#"<object id="3" x="0" y="0"><polygon points="0,0 64,0 0,64 64,64"/></object>"#,
        "",
        &[
            "error no-area at (0, 0): object 3 of layer 'L': no area; it has no inside",
            "error self-crossing at (32, 32): object 3 of layer 'L', edges 1 and 3: the outline crosses itself; inside and outside change places there",
        ],
    ),
    (
        "open_hole",
        r#"<object id="3" type="Hole" x="0" y="0"><polyline points="0,0 64,0 64,64"/></object>"#,
        "",
        &["error not-closed at (0, 0): object 3 of layer 'L': a hole of 3 points that is not closed; it has no inside"],
    ),
    (
        "one_point",
        r#"<object id="3" x="0" y="0"><polyline points="0,0"/></object><object id="4" x="0" y="16" width="64" height="64"/>"#,
        "",
        &[
            "warning left-out at (0, 0): object 3 of layer 'L': it has no second point, so it is not solid: draw one; nothing collides with it",
        ],
    ),
    (
        "far",
        r#"<object id="3" x="8180" y="0" width="12" height="9"/>"#,
        "",
        &[
            "error out-of-domain at (8192, 0): object 3 of layer 'L': a point beyond the domain; coordinates stay below 8192 pixels",
        ],
    ),
    (
        "lattice",
        r#"<object id="3" x="0.1" y="0"><polygon points="0,0 32,0.25 32,32.1"/></object>"#,
        "",
        &[
            "note off-lattice at (0.10001, 0): object 3 of layer 'L': 3 of 3 points lie between raw units and were rounded, this one by 0.400 raw; points that should lie on a line or on each other may miss it by a raw unit",
        ],
    ),
    (
        "bow",
        r#"<object id="3" x="0" y="0"><polygon points="0,0 32,32 32,0 0,48"/></object>"#,
        "",
        &[
            "error self-crossing at (19.2, 19.2): object 3 of layer 'L', edges 0 and 2: the outline crosses itself; inside and outside change places there",
        ],
    ),
    (
        "pinch",
        r#"<object id="3" x="0" y="0"><polygon points="0,0 32,0 16,16 32,32 0,32 16,16"/></object>"#,
        "",
        &[
            "warning self-touch at (16, 16): object 3 of layer 'L', edges 2 and 5: the outline touches itself; two parts of one outline meet in a point that bodies cannot pass",
        ],
    ),
    (
        "spike",
        r#"<object id="3" x="0" y="0"><polygon points="0,0 32,0 32,48 32,32 0,32"/></object>"#,
        "",
        &[
            "error reversed at (32, 32): object 3 of layer 'L', edges 1 and 2: they lie on each other for a part of their length, the other way round; the outline doubles back: a spike without area",
            "warning self-touch at (32, 32): object 3 of layer 'L', edges 1 and 3: the outline touches itself; two parts of one outline meet in a point that bodies cannot pass",
        ],
    ),
    (
        "same_wall",
        r#"<object id="3" x="0" y="0"><polyline points="0,8 32,8"/></object><object id="4" x="0" y="0"><polyline points="40,8 16,8"/></object>"#,
        "",
        &[
            "error duplicate at (16, 8): object 3 of layer 'L', edge 0 and object 4 of layer 'L', edge 0: they lie on each other for a part of their length; each query meets the same face twice",
        ],
    ),
    (
        "same_solid",
        r#"<object id="3" x="0" y="0" width="32" height="32"/><object id="4" x="0" y="0" width="32" height="48"/>"#,
        "",
        &[
            "error duplicate at (0, 0): object 3 of layer 'L', edge 0 and object 4 of layer 'L', edge 0: they are the same edge; each query meets the same face twice",
            "error duplicate at (32, 0): object 3 of layer 'L', edge 1 and object 4 of layer 'L', edge 1: they lie on each other for a part of their length; each query meets the same face twice",
            "error duplicate at (0, 0): object 3 of layer 'L', edge 3 and object 4 of layer 'L', edge 3: they lie on each other for a part of their length; each query meets the same face twice",
            "warning solid-buried at (16, 32): object 3 of layer 'L': a solid within a solid; it changes nothing and costs time",
            "note t-junction at (32, 32): object 3 of layer 'L', edge 2 and object 4 of layer 'L', edge 1: one ends within the other; the solids are joined there, and bodies meet no corner",
            "note t-junction at (0, 32): object 3 of layer 'L', edge 2 and object 4 of layer 'L', edge 3: one ends within the other; the solids are joined there, and bodies meet no corner",
        ],
    ),
    (
        "joined",
        r#"<object id="3" x="0" y="0" width="32" height="32"/><object id="4" x="32" y="0" width="32" height="32"/>"#,
        "",
        &[
            "note reversed at (32, 0): object 3 of layer 'L', edge 1 and object 4 of layer 'L', edge 3: they are the same edge, the other way round; the two cancel and the solids are joined; draw them as one to save the work",
        ],
    ),
    (
        "back_to_back",
        r#"<object id="3" type="OneWay" x="0" y="0"><polyline points="0,0 0,32"/></object><object id="4" type="OneWay" x="0" y="0"><polyline points="0,32 0,0"/></object>"#,
        "",
        &[
            "warning reversed at (0, 0): object 3 of layer 'L', edge 0 and object 4 of layer 'L', edge 0: they are the same edge, the other way round; two one-way edges back to back are a wall: draw a wall",
        ],
    ),
    (
        "crossing",
        r#"<object id="3" x="0" y="0" width="32" height="32"/><object id="4" x="16" y="16" width="32" height="33"/>"#,
        "",
        &[
            "warning crossing at (32, 16): object 3 of layer 'L', edge 1 and object 4 of layer 'L', edge 0: they cross; a body may catch where they cross: no corner is there; put one on the other's edge, or draw one polygon",
            "warning crossing at (16, 32): object 3 of layer 'L', edge 2 and object 4 of layer 'L', edge 3: they cross; a body may catch where they cross: no corner is there; put one on the other's edge, or draw one polygon",
        ],
    ),
    (
        "notch",
        r#"<object id="3" x="0" y="0" width="32" height="32"/><object id="4" type="Hole" x="8" y="16" width="8" height="32"/>"#,
        "",
        &[
            "error crossing at (16, 32): object 3 of layer 'L', edge 2 and object 4 of layer 'L', edge 1: they cross; a hole in nothing keeps an edge that bodies meet from one side",
            "error crossing at (8, 32): object 3 of layer 'L', edge 2 and object 4 of layer 'L', edge 3: they cross; a hole in nothing keeps an edge that bodies meet from one side",
        ],
    ),
    (
        "through",
        r#"<object id="3" x="0" y="0" width="32" height="32"/><object id="4" type="OneWay" x="0" y="0"><polyline points="16,16 48,16"/></object>"#,
        "",
        &[
            "note crossing at (32, 16): object 3 of layer 'L', edge 1 and object 4 of layer 'L', edge 0: they cross; a one-way edge continues within",
        ],
    ),
    (
        "tee",
        r#"<object id="3" x="0" y="0" width="32" height="32"/><object id="4" x="0" y="0"><polyline points="32,8 48,8"/></object>"#,
        "",
        &[
            "note t-junction at (32, 8): object 3 of layer 'L', edge 1 and object 4 of layer 'L', edge 0: one ends within the other; the solids are joined there, and bodies meet no corner",
        ],
    ),
    (
        "stray",
        r#"<object id="3" x="0" y="0" width="32" height="32"/><object id="4" x="64" y="0" width="8" height="8"><properties><property name="kind" value="hole"/></properties></object>"#,
        "",
        &[
            "error hole-outside at (68, 0): object 4 of layer 'L': a hole outside any solid; its edge blocks bodies from within",
        ],
    ),
    (
        "deep",
        r#"<object id="3" x="0" y="0" width="32" height="32"/><object id="4" x="4" y="4" width="24" height="24"/><object id="5" type="Hole" x="8" y="8" width="8" height="8"/>"#,
        "",
        &[
            "error hole-buried at (12, 8): object 5 of layer 'L': a hole where 2 solids lie on each other; it stays solid, yet has edges",
            "warning solid-buried at (16, 4): object 4 of layer 'L': a solid within a solid; it changes nothing and costs time",
        ],
    ),
    (
        "island",
        r#"<object id="3" x="0" y="0" width="32" height="32"/><object id="4" type="Hole" x="4" y="4" width="24" height="24"/><object id="5" x="8" y="8" width="8" height="8"/>"#,
        "",
        &[],
    ),
    (
        "slot",
        r#"<object id="3" x="0" y="0" width="32" height="32"/><object id="4" x="40" y="0" width="32" height="32"/>"#,
        "--body 9x30",
        &[
            "warning pocket at (36, 16): object 3 of layer 'L', edge 1 and object 4 of layer 'L', edge 3: the room between them is 8 wide, the body 9; the body cannot get in, or gets stuck on its way",
        ],
    ),
    (
        "slot_that_fits",
        r#"<object id="3" x="0" y="0" width="32" height="32"/><object id="4" x="40" y="0" width="32" height="32"/>"#,
        "--body 8x30",
        &[],
    ),
    (
        "slot_for_a_ball",
        r#"<object id="3" x="0" y="0" width="32" height="32"/><object id="4" x="40" y="0" width="32" height="32"/>"#,
        "--circle 4.5",
        &[
            "warning pocket at (36, 16): object 3 of layer 'L', edge 1 and object 4 of layer 'L', edge 3: the room between them is 8 wide, the body 9; the body cannot get in, or gets stuck on its way",
        ],
    ),
    (
        "wedge",
        r#"<object id="3" x="0" y="0"><polygon points="0,0 32,0 36,32 40,0 64,0 64,64 0,64"/></object>"#,
        "--body 9x9",
        &[
            "warning pocket at (36, 16): object 3 of layer 'L', edges 1 and 2: the room between them is 0 to 8 wide, the body 9; the body cannot get in, or gets stuck on its way",
        ],
    ),
    (
        "wide_wedge",
        r#"<object id="3" x="0" y="0"><polygon points="0,0 32,0 36,32 40,0 64,0 64,64 0,64"/></object>"#,
        "--body 8x9",
        &[],
    ),
    (
        "hidden_slot",
        r#"<object id="3" x="0" y="0" width="32" height="32"/><object id="4" x="34" y="0" width="2" height="32"/><object id="5" x="38" y="0" width="32" height="32"/>"#,
        "--body 9x9",
        &[
            "warning pocket at (33, 16): object 3 of layer 'L', edge 1 and object 4 of layer 'L', edge 3: the room between them is 2 wide, the body 9; the body cannot get in, or gets stuck on its way",
            "warning pocket at (37, 16): object 4 of layer 'L', edge 1 and object 5 of layer 'L', edge 3: the room between them is 2 wide, the body 9; the body cannot get in, or gets stuck on its way",
        ],
    ),
    (
        "lid",
        r#"<object id="3" x="0" y="0" width="32" height="32"/><object id="4" type="OneWay" x="0" y="0"><polyline points="4,32 28,32"/></object>"#,
        "",
        &[
            "warning unreachable at (16, 32): object 4 of layer 'L', edge 0: a solid lies along its whole front; a one-way edge stops only bodies entirely in front of it, and none can be there",
            "note overlap at (4, 32): object 3 of layer 'L', edge 2 and object 4 of layer 'L', edge 0: they lie on each other for a part of their length; bodies meet both, and one can hide the other if that has one side",
        ],
    ),
    (
        "low",
        r#"<object id="3" x="0" y="0" width="32" height="32"/><object id="4" type="OneWay" x="0" y="0"><polyline points="4,40 28,40"/></object>"#,
        "--body 6x10",
        &[
            "warning unreachable at (16, 40): object 4 of layer 'L', edge 0: a solid along its whole front is nearer than the size of the body; a one-way edge stops only bodies entirely in front of it, and none can be there",
        ],
    ),
    (
        "low_in_part",
        r#"<object id="3" x="0" y="0" width="32" height="32"/><object id="4" type="OneWay" x="0" y="0"><polyline points="4,40 33,40"/></object>"#,
        "--body 6x10",
        &[],
    ),
    (
        "low_slope",
        r#"<object id="3" x="0" y="0"><polygon points="0,0 64,0 64,32 0,16"/></object><object id="4" type="OneWay" x="0" y="0"><polyline points="8,26 56,38"/></object>"#,
        "--circle 4",
        &[
            "warning unreachable at (32, 32): object 4 of layer 'L', edge 0: a solid along its whole front is nearer than the size of the body; a one-way edge stops only bodies entirely in front of it, and none can be there",
        ],
    ),
    (
        "exactly_under_a_slope",
        r#"<object id="3" x="0" y="0"><polygon points="0,0 80,0 80,60"/></object><object id="4" type="OneWay" x="0" y="0"><polyline points="2,14 66,62"/></object>"#,
        "--circle 5",
        &[],
    ),
    (
        "just_too_low",
        r#"<object id="3" x="0" y="0"><polygon points="0,0 80,0 80,60"/></object><object id="4" type="OneWay" x="0" y="0"><polyline points="2,14 66,62"/></object>"#,
        "--circle 5.00001",
        &[
            "warning unreachable at (34, 38): object 4 of layer 'L', edge 0: a solid along its whole front is nearer than the size of the body; a one-way edge stops only bodies entirely in front of it, and none can be there",
        ],
    ),
    (
        "sloped_slot_that_fits",
        r#"<object id="3" x="0" y="0"><polyline points="0,0 80,60"/></object><object id="4" x="0" y="0"><polyline points="2,14 66,62"/></object>"#,
        "--circle 5",
        &[],
    ),
    (
        "sloped_slot",
        r#"<object id="3" x="0" y="0"><polyline points="0,0 80,60"/></object><object id="4" x="0" y="0"><polyline points="2,14 66,62"/></object>"#,
        "--circle 5.00001",
        &[
            "warning pocket at (37, 34): object 3 of layer 'L', edge 0 and object 4 of layer 'L', edge 0: the room between them is 10 wide, the body 10.00003; the body cannot get in, or gets stuck on its way",
        ],
    ),
    (
        "buried",
        r#"<object id="3" x="0" y="0" width="32" height="32"/><object id="4" type="OneWay" x="0" y="0"><polyline points="4,12 28,12"/></object>"#,
        "",
        &[
            "warning unreachable at (16, 12): object 4 of layer 'L', edge 0: it lies within the solid; a one-way edge stops only bodies entirely in front of it, and none can be there",
        ],
    ),
    (
        "other",
        r#"<object id="1" width="32" height="32"/><object id="3" x="1" y="2" width="32" height="32"><text/></object><object id="5" x="3"/>"#,
        "",
        &[
            "note left-out at (1, 2): object 3 of layer 'L': it is a text; it is not solid: bake writes it to OBJECTS",
            "note left-out at (3, 0): object 5 of layer 'L': it has no size, so it is a point; it is not solid: bake writes it to OBJECTS",
        ],
    ),
];
