//! The screen as a file.

use std::error::Error;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

use crate::host::Screen;

/// Each pixel becomes `scale` x `scale`.
pub fn save(path: &Path, screen: &Screen, scale: usize) -> Result<(), Box<dyn Error>> {
    let mut data = Vec::with_capacity(screen.rgb.len() * scale * scale);
    for row in screen.rgb.chunks_exact((screen.width * 3).max(1)) {
        let wide: Vec<u8> = row.chunks_exact(3).flat_map(|pixel| pixel.repeat(scale)).collect();
        data.extend(wide.repeat(scale));
    }
    let side = |pixels: usize| u32::try_from(pixels * scale);
    let file = BufWriter::new(File::create(path)?);
    let mut encoder = png::Encoder::new(file, side(screen.width)?, side(screen.height)?);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    encoder.write_header()?.write_image_data(&data)?;
    Ok(())
}
