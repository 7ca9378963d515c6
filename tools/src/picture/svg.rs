//! Writes the picture as SVG.

use std::fmt::Write;

use super::ink::{Ink, PAPER};
use super::marks::{Mark, Scene, Spot};

/// A fading line has this many pieces of rising opacity.
const PIECES: usize = 6;

/// The text of a picture's file.
pub fn text(scene: &Scene) -> String {
    let (w, h, s) = (scene.size.0, scene.size.1, scene.scale);
    let (wide, high, letter) = (w * s, h * s, Scene::LETTER.1 / s);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{wide}\" height=\"{high}\" viewBox=\"0 0 {w} {h}\" \
         font-family=\"monospace\" font-size=\"{letter}\">\n<rect width=\"{w}\" height=\"{h}\" {}/>\n",
        paint("fill", PAPER)
    );
    for mark in &scene.marks {
        element(&mut out, scene, mark);
    }
    out.push_str("</svg>\n");
    out
}

/// Writing to a string cannot fail, so the results are dropped.
fn element(out: &mut String, scene: &Scene, mark: &Mark) {
    match mark {
        Mark::Rect { at: (x, y), size: (w, h), fill } => {
            let fill = paint("fill", *fill);
            let _ = writeln!(out, "<rect x=\"{x:.2}\" y=\"{y:.2}\" width=\"{w:.2}\" height=\"{h:.2}\" {fill}/>");
        }
        Mark::Disc { centre: (x, y), radius, fill } => {
            let fill = paint("fill", *fill);
            let _ = writeln!(out, "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius:.2}\" {fill}/>");
        }
        Mark::Ring { centre: (x, y), radius, width, ink } => {
            let ink = paint("stroke", *ink);
            let _ = writeln!(
                out,
                "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius:.2}\" fill=\"none\" stroke-width=\"{width:.2}\" {ink}/>"
            );
        }
        Mark::Poly { points, fill } => {
            let _ = writeln!(out, "<polygon points=\"{}\" {}/>", list(points), paint("fill", *fill));
        }
        Mark::Line { points, width, ink, fade } => {
            let pieces = if *fade { PIECES } else { 1 };
            for piece in 0..pieces {
                let (from, to) = (points.len() * piece / pieces, points.len() * (piece + 1) / pieces);
                let strength = (piece + 1) as f32 / pieces as f32;
                // One more point joins the pieces.
                let part = &points[from..(to + 1).min(points.len())];
                let ink = paint("stroke", ink.alpha(ink.alpha * strength));
                let _ = writeln!(
                    out,
                    "<polyline points=\"{}\" fill=\"none\" stroke-width=\"{width:.2}\" stroke-linejoin=\"round\" {ink}/>",
                    list(part)
                );
            }
        }
        Mark::Text { at: (x, y), text, ink } => {
            let wide = text.chars().count() as f32 * Scene::LETTER.0 / scene.scale;
            let (ink, text) = (paint("fill", *ink), escape(text));
            let _ = writeln!(out, "<text x=\"{x:.2}\" y=\"{y:.2}\" textLength=\"{wide:.2}\" {ink}>{text}</text>");
        }
    }
}

fn paint(what: &str, ink: Ink) -> String {
    let [r, g, b] = ink.rgb;
    let opacity = if ink.alpha < 1.0 { format!(" {what}-opacity=\"{:.2}\"", ink.alpha) } else { String::new() };
    format!("{what}=\"#{r:02x}{g:02x}{b:02x}\"{opacity}")
}

fn list(points: &[Spot]) -> String {
    points.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect::<Vec<_>>().join(" ")
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
