//! Two machines over links that lose packets: equal states after each confirmed frame, and no
//! unnecessary replay.

use tilesat::TileMap;
use tilesat_games::rollback::{Game, Keys, Matched, Totals, Weather, arena};
use tilesat_judge::cases;

/// From a perfect link to one that hardly lets anything through.
const LINKS: [Weather; 5] = [
    Weather { loss: 0, doubled: 0, least: 0, most: 0 },
    Weather { loss: 0, doubled: 0, least: 5, most: 5 },
    Weather { loss: 10, doubled: 30, least: 1, most: 8 },
    Weather { loss: 40, doubled: 5, least: 3, most: 12 },
    Weather { loss: 75, doubled: 20, least: 0, most: 20 },
];

fn play(weather: Weather, seed: u64, frames: u32) -> Totals {
    let mut matched = Matched::new(arena().unwrap(), weather, seed).unwrap();
    while matched.totals().confirmed < frames {
        assert_eq!(matched.call(), Ok(()), "{weather:?}, {seed}");
        assert!(matched.totals().calls < 20 * frames, "it stands still");
    }
    matched.totals()
}

/// The states of both machines take half a megabyte, more than a test's stack has room for.
#[test]
fn both_machines_have_one_game() {
    let run = std::thread::Builder::new().stack_size(32 << 20).spawn(all_links).unwrap();
    run.join().unwrap();
}

fn all_links() {
    let mut sum = [Totals::default(); LINKS.len()];
    for (weather, total) in LINKS.into_iter().zip(&mut sum) {
        for seed in 0..cases(3) {
            let Totals { rollbacks, again, waits, lost, doubled, overtaken, .. } = play(weather, seed, 400);
            total.rollbacks += rollbacks;
            total.again += again;
            total.waits += waits;
            total.lost += lost;
            total.doubled += doubled;
            total.overtaken += overtaken;
        }
    }
    // Packets that arrive in time need no rollback. The worst link causes deep ones, and stops the
    // game.
    assert_eq!((sum[0].again, sum[0].waits), (0, 0));
    // Keys that travel 5 frames and take effect after 2 are 3 frames late, each time.
    assert!(sum[1].rollbacks > 30 && sum[1].again == sum[1].rollbacks * 3 && sum[1].overtaken == 0, "{:?}", sum[1]);
    assert!(sum[2].doubled > 500 && sum[2].overtaken > 500 && sum[2].lost > 100, "{:?}", sum[2]);
    assert!(sum[4].waits > 0 && sum[4].again > sum[3].again, "{:?}", sum[4]);
}

#[test]
fn the_game_is_in_the_snapshot_alone() {
    let level: TileMap<'_> = arena().unwrap();
    let (mut game, mut changed) = (Game::new().unwrap(), 0);
    for frame in 0..200 {
        let keys = [Keys(frame as u8 / 32), Keys(7 - frame as u8 / 32)];
        game.step(&level, keys).unwrap();
        // A new game continues like this one.
        let mut other = Game::new().unwrap();
        other.load(&game.save());
        let (mut one, mut two) = (game, other);
        one.step(&level, keys).unwrap();
        two.step(&level, keys).unwrap();
        assert!(one.save() == two.save(), "frame {frame}");
        // A player who runs into what is at a wall stays as it is.
        changed += u32::from(one.save() != game.save());
    }
    assert!(changed > 180, "only {changed} frames change the game");
}
