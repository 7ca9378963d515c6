//! One backend's loop over one class of inputs. Only this loop is timed and counted.

use std::hint::black_box;
use std::rc::Rc;

/// The number format of a backend, which gives its unit in the last place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Format {
    /// This many parts per pixel (or per motion).
    Parts(f64),
    F32,
    F64,
}

impl Format {
    /// Raw units.
    pub const RAW: Self = Self::Parts(65536.0);

    /// One unit in the last place of a value.
    pub fn ulp(self, value: f64) -> f64 {
        match self {
            Self::Parts(n) => 1.0 / n,
            Self::F32 => {
                let v = (value as f32).abs().max(f32::MIN_POSITIVE);
                f64::from(f32::from_bits(v.to_bits() + 1) - v)
            }
            Self::F64 => {
                let v = value.abs().max(f64::MIN_POSITIVE);
                f64::from_bits(v.to_bits() + 1) - v
            }
        }
    }
}

/// Inputs in a backend's own shapes, its answers, and the loop between them.
pub trait Job<A> {
    fn pass(&mut self);
    fn answers(&self) -> Vec<A>;
    fn len(&self) -> usize;
}

struct Loop<P, O, F, A> {
    inputs: Vec<P>,
    outputs: Vec<O>,
    ask: F,
    read: fn(&O) -> A,
}

impl<P, O, F: Fn(&P) -> O, A> Job<A> for Loop<P, O, F, A> {
    /// Hides each input from the compiler and stores each answer. So it costs a single call; the
    /// compiler cannot vectorise the loop.
    #[inline(never)]
    fn pass(&mut self) {
        for (input, output) in self.inputs.iter().zip(&mut self.outputs) {
            *output = (self.ask)(black_box(input));
        }
    }

    fn answers(&self) -> Vec<A> {
        self.outputs.iter().map(self.read).collect()
    }

    fn len(&self) -> usize {
        self.outputs.len()
    }
}

type Make<I, A> = Rc<dyn Fn(&[I]) -> Box<dyn Job<A>>>;

/// One row of a table: the backend, and which of its questions.
#[derive(Clone)]
pub struct Backend<I, A> {
    pub name: &'static str,
    pub asked: &'static str,
    pub format: Format,
    pub make: Make<I, A>,
    /// Whether this call returns without ending the program.
    pub fits: fn(&I) -> bool,
}

/// The backends of a workload.
pub struct List<I, A>(pub Vec<Backend<I, A>>);

impl<I: 'static, A: 'static> List<I, A> {
    /// A backend: its shapes from the raw input, its question, and the meaning of its answer.
    pub fn add<P: 'static, O: 'static>(
        &mut self,
        (name, asked, format): (&'static str, &'static str, Format),
        prepare: impl Fn(&I) -> P + 'static,
        ask: impl Fn(&P) -> O + Copy + 'static,
        read: fn(&O) -> A,
    ) {
        let make: Make<I, A> = Rc::new(move |raw| {
            let inputs: Vec<P> = raw.iter().map(&prepare).collect();
            let outputs = inputs.iter().map(ask).collect();
            Box::new(Loop { inputs, outputs, ask, read })
        });
        self.0.push(Backend { name, asked, format, make, fits: |_| true });
    }

    /// The last backend runs only in classes whose inputs all fit.
    pub fn only_if(&mut self, fits: fn(&I) -> bool) {
        if let Some(last) = self.0.last_mut() {
            last.fits = fits;
        }
    }
}
