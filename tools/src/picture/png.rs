//! Writes the picture as PNG, with the letters of embedded-graphics.

use std::convert::Infallible;
use std::fs;
use std::path::Path;

use embedded_graphics::mono_font::MonoTextStyle;
use embedded_graphics::mono_font::ascii::FONT_9X15;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics::text::Text;
use png::{BitDepth, ColorType, Encoder};

use super::canvas::Canvas;
use super::ink::PAPER;
use super::marks::{Mark, Scene, Spot};
use crate::fail::{Fail, Result};

/// Draws a picture and writes it.
///
/// # Errors
///
/// If the file cannot be written.
pub fn write(scene: &Scene, path: &Path) -> Result<()> {
    fs::write(path, bytes(scene)?).map_err(|e| Fail::new(format!("cannot write {}: {e}", path.display())))
}

/// The bytes of a picture's file.
///
/// # Errors
///
/// If it is too large for a PNG.
pub fn bytes(scene: &Scene) -> Result<Vec<u8>> {
    let s = scene.scale;
    let at = |p: &Spot| (p.0 * s, p.1 * s);
    let size = at(&scene.size);
    let mut canvas = Canvas::new(size.0.ceil() as usize, size.1.ceil() as usize, PAPER);
    if let Some(image) = &scene.backdrop {
        canvas.image(image);
    }
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
    for mark in &scene.marks {
        if let Mark::Text { at: corner, text, ink } = mark {
            let [r, g, b] = ink.rgb;
            let (x, y) = at(corner);
            let style = MonoTextStyle::new(&FONT_9X15, Rgb888::new(r, g, b));
            let Ok(_) = Text::new(text, Point::new(x as i32, y as i32), style).draw(&mut canvas);
        }
    }
    encoded(&canvas).map_err(|e| Fail::new(format!("cannot draw: {e}")))
}

fn encoded(canvas: &Canvas) -> std::result::Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, canvas.width as u32, canvas.height as u32);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    let mut image = encoder.write_header()?;
    image.write_image_data(canvas.pixels.as_flattened())?;
    image.finish()?;
    Ok(bytes)
}

impl OriginDimensions for Canvas {
    fn size(&self) -> Size {
        Size::new(self.width as u32, self.height as u32)
    }
}

impl DrawTarget for Canvas {
    type Color = Rgb888;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb888>>>(&mut self, pixels: I) -> std::result::Result<(), Infallible> {
        let size = self.size();
        for Pixel(at, colour) in pixels {
            if Rectangle::new(Point::zero(), size).contains(at) {
                let place = at.y as usize * self.width + at.x as usize;
                self.pixels[place] = [colour.r(), colour.g(), colour.b()];
            }
        }
        Ok(())
    }
}
