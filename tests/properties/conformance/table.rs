//! A table as text: a line of names, then a line per row, with commas between. No cell contains a
//! comma, a quote or a line end.

use tilesat_judge::oracle::figure::{Figure, Point};

#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Table {
    pub(crate) names: Vec<String>,
    pub(crate) rows: Vec<Vec<String>>,
}

impl Table {
    pub(crate) fn new(names: &str) -> Self {
        Self { names: names.split(',').map(str::to_owned).collect(), rows: Vec::new() }
    }

    /// Names of cases have semicolons instead of commas.
    pub(crate) fn push(&mut self, row: &[String]) {
        assert_eq!(row.len(), self.names.len(), "{row:?}");
        let row: Vec<String> = row.iter().map(|cell| cell.replace(',', ";")).collect();
        assert!(row.iter().all(|cell| !cell.contains(['"', '\n'])), "{row:?}");
        self.rows.push(row);
    }

    pub(crate) fn text(&self) -> String {
        let lines = [&self.names].into_iter().chain(&self.rows).map(|row| row.join(","));
        lines.fold(String::new(), |all, line| all + &line + "\n")
    }

    pub(crate) fn parse(text: &str) -> Self {
        let mut lines = text.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
        Self { names: lines.next().unwrap(), rows: lines.collect() }
    }

    /// Each row, whose cells are read by name.
    pub(crate) fn each(&self, mut f: impl FnMut(Row<'_>)) {
        self.rows.iter().for_each(|row| f(Row { table: self, row }));
    }
}

#[derive(Clone, Copy)]
pub(crate) struct Row<'a> {
    table: &'a Table,
    row: &'a [String],
}

impl std::fmt::Debug for Row<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_map().entries(self.table.names.iter().zip(self.row)).finish()
    }
}

impl<'a> Row<'a> {
    pub(crate) fn text(&self, name: &str) -> &'a str {
        let column = self.table.names.iter().position(|n| n == name).unwrap_or_else(|| panic!("no column {name}"));
        &self.row[column]
    }

    pub(crate) fn yes(&self, name: &str) -> bool {
        self.text(name) == "1"
    }

    pub(crate) fn number(&self, name: &str) -> i64 {
        self.text(name).parse().unwrap_or_else(|e| panic!("{name}: {e} in {:?}", self.row))
    }

    /// `None` if the cell is empty.
    pub(crate) fn maybe(&self, name: &str) -> Option<i64> {
        (!self.text(name).is_empty()).then(|| self.number(name))
    }

    pub(crate) fn point(&self, name: &str) -> Point {
        numbers(self.text(name))[..].try_into().map(|[x, y]: [i64; 2]| (x, y)).unwrap()
    }

    /// Directions with bars between them.
    pub(crate) fn points(&self, name: &str) -> Vec<Point> {
        self.text(name)
            .split('|')
            .filter(|t| !t.is_empty())
            .map(|t| {
                let n = numbers(t);
                (n[0], n[1])
            })
            .collect()
    }

    pub(crate) fn figure(&self, name: &str) -> Figure {
        let text = self.text(name);
        let n = numbers(&text[2..]);
        match &text[..1] {
            "B" => Figure::Aabb { min: (n[0], n[1]), max: (n[2], n[3]) },
            "C" => Figure::Circle { centre: (n[0], n[1]), radius: n[2] },
            _ => Figure::Segment { a: (n[0], n[1]), b: (n[2], n[3]) },
        }
    }
}

fn numbers(text: &str) -> Vec<i64> {
    text.split(' ').map(|n| n.parse().unwrap_or_else(|e| panic!("{text}: {e}"))).collect()
}

pub(crate) fn bit(yes: bool) -> String {
    u8::from(yes).to_string()
}

pub(crate) fn pair(p: Point) -> String {
    format!("{} {}", p.0, p.1)
}

pub(crate) fn maybe<T: ToString>(value: Option<T>) -> String {
    value.map_or_else(String::new, |v| v.to_string())
}

pub(crate) fn list(points: &[Point]) -> String {
    points.iter().map(|p| pair(*p)).collect::<Vec<_>>().join("|")
}

pub(crate) fn figure(f: &Figure) -> String {
    match *f {
        Figure::Aabb { min, max } => format!("B {} {}", pair(min), pair(max)),
        Figure::Circle { centre, radius } => format!("C {} {radius}", pair(centre)),
        Figure::Segment { a, b } => format!("S {} {}", pair(a), pair(b)),
    }
}

pub(crate) fn reduced(p: Point) -> Point {
    fn gcd(a: i64, b: i64) -> i64 {
        if b == 0 { a.abs() } else { gcd(b, a % b) }
    }
    let g = gcd(p.0, p.1).max(1);
    (p.0 / g, p.1 / g)
}
