//! Sets refuse what they do not have, and slopes end where they should.

#[allow(clippy::unreachable, reason = "a test")]
mod set {
    use crate::num::{Fx, Vec2};
    use crate::world::TileShape;
    use crate::world::sealed::Sealed;
    use crate::world::tile_map::surface::BlockSurface;
    use crate::world::tile_map::{Bits, Blocks, Bytes, ShapeSet, bits};
    use crate::world::{Grid, TileKind, TileKinds, TileMap, TileMapError};

    /// A set without one-way tiles: a table can name a shape that is not in it.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    struct FullOnly;

    impl Sealed for FullOnly {}
    impl ShapeSet for FullOnly {
        const SHAPES: u64 = bits(TileShape::Empty, TileShape::Full);
        type CellSurface = BlockSurface;
    }

    #[test]
    fn a_shape_that_is_not_in_the_set_is_refused() {
        static FINE: TileKinds = TileKinds::EMPTY.with(255, TileKind::FULL.with_flags(255));
        static ONE: TileKinds = FINE.with(255, TileKind::ONE_WAY_UP);
        static TWO: TileKinds = ONE.with(7, TileKind::ONE_WAY_UP);
        static FIRST: TileKinds = TWO.with(0, TileKind::ONE_WAY_UP);
        let Ok(grid) = Grid::new(2, 1, Fx::lit("16"), Vec2::ZERO) else { unreachable!() };
        let build = |kinds: &'static TileKinds| TileMap::<FullOnly, Bytes>::build(&[0; 2], grid, 2, kinds).map(|_| ());
        assert_eq!(build(&FINE), Ok(()));
        assert_eq!(build(&ONE), Err(TileMapError::ShapeNotInSet { id: 255 }));
        assert_eq!(build(&TWO), Err(TileMapError::ShapeNotInSet { id: 7 }));
        assert_eq!(build(&FIRST), Err(TileMapError::ShapeNotInSet { id: 0 }));
        // Blocks has them all, whatever the store.
        assert!(TileMap::<Blocks, Bytes>::build(&[0; 2], grid, 2, &FIRST).is_ok());
        assert!(TileMap::<Blocks, Bits>::build(&[0; 1], grid, 2, &FIRST).is_ok());
    }
}

#[allow(clippy::panic, clippy::indexing_slicing, reason = "a test")]
mod outline {
    use crate::world::TileShape;
    use crate::world::tile_map::outline::FormKind;

    /// The twelve slopes as the corners that N++ gives them, in halves of a cell, y down.
    #[test]
    fn slopes_end_where_they_should() {
        let lines = [
            (6, (0, 2), (2, 0)),
            (7, (0, 0), (2, 2)),
            (8, (2, 0), (0, 2)),
            (9, (2, 2), (0, 0)),
            (18, (0, 1), (2, 0)),
            (19, (0, 0), (2, 1)),
            (20, (2, 1), (0, 2)),
            (21, (2, 2), (0, 1)),
            (22, (0, 2), (2, 1)),
            (23, (0, 1), (2, 2)),
            (24, (2, 0), (0, 1)),
            (25, (2, 1), (0, 0)),
            (26, (0, 2), (1, 0)),
            (27, (1, 0), (2, 2)),
            (28, (2, 0), (1, 2)),
            (29, (1, 2), (0, 0)),
            (30, (1, 2), (2, 0)),
            (31, (0, 0), (1, 2)),
            (32, (1, 0), (0, 2)),
            (33, (2, 2), (1, 0)),
            (2, (0, 1), (2, 1)),
            (3, (1, 0), (1, 2)),
            (4, (2, 1), (0, 1)),
            (5, (1, 2), (1, 0)),
        ];
        for (id, a, b) in lines {
            let form = TileShape::ALL[id].form();
            let FormKind::Line { p, q, k } = form.kind else { panic!("{id}") };
            for (x, y) in [a, b] {
                let (u, v) = (if form.right { 2 - x } else { x }, if form.bottom { 2 - y } else { y });
                assert_eq!(p * u + q * v, k, "{id} at {x}, {y}");
            }
        }
        for (id, right, bottom) in [(10, false, false), (11, true, false), (16, true, true), (17, false, true)] {
            let form = TileShape::ALL[id].form();
            assert_eq!((form.right, form.bottom), (right, bottom), "{id}");
            assert_eq!(form.kind == FormKind::Convex, id < 14);
        }
        // All shapes are there, each once.
        assert!(TileShape::ALL.iter().enumerate().all(|(i, &s)| s as usize == i));
    }
}
