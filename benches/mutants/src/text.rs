//! Sources whose functions contain their mutants.

use crate::mutant::{Mutant, Spot};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// The end of a function's span, which names it.
pub(crate) type End = usize;

pub(crate) struct Source {
    pub(crate) file: String,
    text: Vec<char>,
    functions: Vec<Function>,
}

struct Function {
    /// Positions of its braces in the text: at the first, and behind the second.
    body: (usize, usize),
    mutants: Vec<(u32, usize, usize, String)>,
}

/// The mutant that a line of the woven text belongs to.
pub(crate) enum Place {
    Arm(u32),
    Match(End),
}

impl Source {
    pub(crate) fn of(tree: &Path, mutants: &[Mutant]) -> Vec<Self> {
        let files: BTreeSet<_> = mutants.iter().map(|mutant| &mutant.file).collect();
        files.into_iter().map(|file| Self::read(tree, file, mutants)).collect()
    }

    fn read(tree: &Path, file: &str, mutants: &[Mutant]) -> Self {
        let text: Vec<char> = fs::read_to_string(tree.join(file)).expect("a source").chars().collect();
        let mut lines = vec![0];
        lines.extend(text.iter().enumerate().filter(|(_, c)| **c == '\n').map(|(i, _)| i + 1));
        let at = |spot: Spot| lines[spot.0 - 1] + spot.1 - 1;
        let mut functions: Vec<Function> = Vec::new();
        for mutant in mutants.iter().filter(|mutant| mutant.file == file) {
            let Some((from, to)) = mutant.function.map(|(from, to)| (at(from), at(to))) else { continue };
            let edit = (mutant.id, at(mutant.span.0), at(mutant.span.1), mutant.replacement.clone());
            match functions.iter_mut().find(|function| function.body.1 == to) {
                Some(function) => function.mutants.push(edit),
                None => functions.push(Function { body: (open_brace(&text, from, to), to), mutants: vec![edit] }),
            }
        }
        // Of nested functions, weaves the outer one with the mutants of both.
        functions.sort_by_key(|function| function.body.0);
        let mut outer: Vec<Function> = Vec::new();
        for function in functions {
            match outer.last_mut() {
                Some(last) if function.body.1 <= last.body.1 => last.mutants.extend(function.mutants),
                _ => outer.push(function),
            }
        }
        Self { file: file.to_owned(), text, functions: outer }
    }

    pub(crate) fn has_arm(&self, id: u32, constant: &BTreeSet<(String, End)>) -> bool {
        let holds = |function: &&Function| function.mutants.iter().any(|mutant| mutant.0 == id);
        self.functions.iter().find(holds).is_some_and(|f| !constant.contains(&(self.file.clone(), f.body.1)))
    }

    pub(crate) fn woven(&self, unviable: &BTreeSet<u32>, constant: &BTreeSet<(String, End)>) -> String {
        self.pieces(unviable, constant).into_iter().map(|piece| piece.0).collect()
    }

    pub(crate) fn at_line(
        &self,
        line: usize,
        unviable: &BTreeSet<u32>,
        constant: &BTreeSet<(String, End)>,
    ) -> Option<Place> {
        let mut first = 1;
        for (text, place) in self.pieces(unviable, constant) {
            let last = first + text.matches('\n').count();
            // Every piece of an arm ends its line.
            if place.is_some() && (first..last).contains(&line) {
                return place;
            }
            first = last;
        }
        None
    }

    fn pieces(&self, unviable: &BTreeSet<u32>, constant: &BTreeSet<(String, End)>) -> Vec<(String, Option<Place>)> {
        let part = |from: usize, to: usize| self.text[from..to].iter().collect::<String>();
        let (mut out, mut done) = (Vec::new(), 0);
        for function in &self.functions {
            let (open, end) = function.body;
            if constant.contains(&(self.file.clone(), end)) {
                continue;
            }
            out.push((part(done, open) + "{\n", None));
            out.push(("match unsafe { crate::ACTIVE } {\n".to_owned(), Some(Place::Match(end))));
            for (id, from, to, replacement) in function.mutants.iter().filter(|mutant| !unviable.contains(&mutant.0)) {
                let arm = format!("{id} => {} {replacement} {}\n", part(open, *from), part(*to, end));
                out.push((arm, Some(Place::Arm(*id))));
            }
            out.push((format!("_ => {}\n}}\n}}", part(open, end)), None));
            done = end;
        }
        out.push((part(done, self.text.len()), None));
        out
    }
}

/// The start of the block that ends a function. Strings and characters in it have no unmatched
/// braces.
fn open_brace(text: &[char], from: usize, to: usize) -> usize {
    let mut depth = 0;
    for at in (from..to).rev() {
        match text[at] {
            '}' => depth += 1,
            '{' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return at;
        }
    }
    panic!("a function has a block");
}
