//! The format of the inputs of microcontrollers: 32-bit words. A name is its length and its bytes.

/// A workload and a class.
pub type Names<'a> = (&'a str, &'a str);

/// A backend, its question and the checksum of its answers.
pub type Answered = (&'static str, &'static str, u32);

#[derive(Default)]
pub struct File(Vec<u8>);

impl File {
    pub fn text(&mut self, text: &str) {
        self.words([text.len() as i64]);
        self.0.extend(text.as_bytes());
    }

    /// The lower 32 bits of each.
    pub fn words(&mut self, words: impl IntoIterator<Item = i64>) {
        words.into_iter().for_each(|word| self.0.extend((word as i32).to_le_bytes()));
    }

    pub fn raw(&mut self, bytes: &[u8]) {
        self.0.extend(bytes);
    }

    /// The names, some words about all records, their number and length, and the backends' answers.
    pub fn class<R: AsRef<[i64]>>(
        &mut self,
        names: Names<'_>,
        about: &[i64],
        records: &[R],
        answers: impl ExactSizeIterator<Item = Answered>,
    ) {
        self.text(names.0);
        self.text(names.1);
        self.words([about.len() as i64]);
        self.words(about.iter().copied());
        self.words([records.len() as i64, records.first().map_or(0, |r| r.as_ref().len()) as i64]);
        records.iter().for_each(|r| self.words(r.as_ref().iter().copied()));
        self.words([answers.len() as i64]);
        for (backend, asked, sum) in answers {
            self.text(backend);
            self.text(asked);
            self.words([sum.into()]);
        }
    }

    /// The words of each query, and whether it hits.
    pub fn queries<R: AsRef<[i64]>>(&mut self, names: Names<'_>, records: &[R]) {
        self.class(names, &[], records, [].into_iter());
    }

    pub fn bytes(self) -> Vec<u8> {
        self.0
    }
}
