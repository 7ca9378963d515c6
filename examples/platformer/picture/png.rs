//! The picture as PNG, with letters and encoder of embedded-graphics.

use std::path::Path;

use embedded_graphics::mono_font::MonoTextStyle;
use embedded_graphics::mono_font::ascii::FONT_9X15;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics::text::Text;
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};

use super::super::fail::{Fail, Result};
use super::canvas::Canvas;
use super::ink::PAPER;
use super::marks::{Mark, Scene, Spot};

pub fn write(scene: &Scene, path: &Path) -> Result<()> {
    let s = scene.scale;
    let at = |p: &Spot| (p.0 * s, p.1 * s);
    let size = at(&scene.size);
    let mut canvas = Canvas::new(size.0.ceil() as usize, size.1.ceil() as usize, PAPER);
    for mark in &scene.marks {
        match mark {
            Mark::Rect { at: corner, size, fill } => canvas.rect(at(corner), at(size), *fill),
            Mark::Disc { centre, radius, fill } => canvas.disc(at(centre), radius * s, *fill),
            Mark::Ring { centre, radius, width, ink } => {
                canvas.ring(at(centre), radius * s, width * s, *ink);
            }
            Mark::Poly { points, fill } => {
                canvas.poly(&points.iter().map(at).collect::<Vec<_>>(), *fill);
            }
            Mark::Line { points, width, ink, fade } => {
                let points: Vec<Spot> = points.iter().map(at).collect();
                canvas.line(&points, width * s, *ink, *fade);
            }
            Mark::Text { .. } => {}
        }
    }
    save(&canvas, scene, path).ok_or_else(|| Fail::new(format!("cannot write {}", path.display())))
}

fn save(canvas: &Canvas, scene: &Scene, path: &Path) -> Option<()> {
    let area = Rectangle::new(Point::zero(), Size::new(canvas.width as u32, canvas.height as u32));
    let mut display: SimulatorDisplay<Rgb888> = SimulatorDisplay::new(area.size);
    let colours = canvas.pixels.iter().map(|&[r, g, b]| Rgb888::new(r, g, b));
    display.fill_contiguous(&area, colours).ok()?;
    for mark in &scene.marks {
        if let Mark::Text { at, text, ink } = mark {
            let [r, g, b] = ink.rgb;
            let style = MonoTextStyle::new(&FONT_9X15, Rgb888::new(r, g, b));
            let at = Point::new((at.0 * scene.scale) as i32, (at.1 * scene.scale) as i32);
            Text::new(text, at, style).draw(&mut display).ok()?;
        }
    }
    display.to_rgb_output_image(&OutputSettings::default()).save_png(path).ok()
}
