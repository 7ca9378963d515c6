//! The properties of a tile, an object or a layer.

/// The value of a property.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Value {
    Bool(bool),
    /// As in the file.
    Number(String),
    Text(String),
    /// A reference to the object with this id.
    Object(u32),
    /// One that no output can hold, and the reason.
    Lost(String),
}

/// The name of the text that a tile of `LDtk` can have.
pub(crate) const CUSTOM_DATA: &str = "custom data";

/// The reasons.
pub(crate) const CLASS: &str = "a class: make its members properties of the object";
pub(crate) const LIST: &str = "a list: make its values properties of the object";

impl Value {
    /// Whether it is a number that is not 0. Some authors use it for true. Before 0.17, Tiled had
    /// no types and wrote it as text.
    pub(crate) fn is_one(&self) -> bool {
        let (Self::Number(digits) | Self::Text(digits)) = self else { return false };
        digits.trim().parse().is_ok_and(|v: f64| v.is_finite() && v != 0.0)
    }

    /// Whether it is false, also as text or as the number 0.
    pub(crate) fn is_false(&self) -> bool {
        match self {
            Self::Bool(is) => !is,
            Self::Number(text) => text == "0",
            Self::Text(text) => text.trim() == "0" || text.trim().eq_ignore_ascii_case("false"),
            Self::Object(_) | Self::Lost(_) => false,
        }
    }

    /// Whether it is true. Old versions of Tiled had no types and wrote the word. Some editors add
    /// blanks and line breaks.
    pub(crate) fn is_true(&self) -> bool {
        match self {
            Self::Bool(is) => *is,
            Self::Text(text) => text.trim().eq_ignore_ascii_case("true"),
            Self::Number(_) | Self::Object(_) | Self::Lost(_) => false,
        }
    }
}

impl From<&serde_json::Value> for Value {
    fn from(value: &serde_json::Value) -> Self {
        match value {
            serde_json::Value::Bool(is) => Self::Bool(*is),
            serde_json::Value::Number(number) => Self::Number(number.to_string()),
            serde_json::Value::String(text) => Self::Text(text.clone()),
            serde_json::Value::Array(_) => Self::Lost(LIST.to_owned()),
            serde_json::Value::Object(_) => Self::Lost(CLASS.to_owned()),
            serde_json::Value::Null => Self::Lost("it has no value".to_owned()),
        }
    }
}

/// Names and values, in the order of the file.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Properties(pub Vec<(String, Value)>);

impl Properties {
    /// The same with a class, as a property of this name.
    #[must_use]
    pub(crate) fn with_class(mut self, class: &str) -> Self {
        if !class.trim().is_empty() {
            self.0.push(("class".to_owned(), Value::Text(class.to_owned())));
        }
        self
    }

    /// The names of the true properties.
    pub fn marks(&self) -> impl Iterator<Item = &str> {
        self.0.iter().filter(|(_, value)| value.is_true()).map(|(name, _)| name.as_str())
    }

    /// The names of numbers that are not 0.
    pub fn ones(&self) -> impl Iterator<Item = &str> {
        self.0.iter().filter(|(_, value)| value.is_one()).map(|(name, _)| name.as_str())
    }

    /// Each property that has a value, as options name it: `kind:wall`, `passable:false`.
    pub fn valued(&self) -> impl Iterator<Item = String> {
        self.0.iter().filter_map(|(name, value)| match value {
            Value::Bool(is) => Some(format!("{name}:{is}")),
            Value::Number(text) | Value::Text(text) => Some(format!("{name}:{}", text.trim())),
            Value::Object(_) | Value::Lost(_) => None,
        })
    }

    /// The value of a property as text, whatever its type. Ignores case in the name.
    pub fn text(&self, name: &str) -> Option<String> {
        let found = self.0.iter().find(|(key, _)| key.eq_ignore_ascii_case(name));
        found.and_then(|(_, value)| match value {
            Value::Bool(is) => Some(is.to_string()),
            Value::Number(text) | Value::Text(text) => Some(text.clone()),
            Value::Object(_) | Value::Lost(_) => None,
        })
    }
}
