//! S-expressions.

/// A number, a name, a text, or several in brackets.
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
    /// A decimal number.
    Number(f64),
    /// A name, an operator or the key of a property.
    Word(String),
    /// Between quotation marks.
    Text(String),
    /// Between brackets, round or square.
    List(Vec<Expression>),
}

/// All expressions of a file.
pub fn all(source: &str) -> Result<Vec<Expression>, String> {
    let pieces = pieces(source);
    let mut rest = &pieces[..];
    let mut expressions = Vec::new();
    while !rest.is_empty() {
        let (expression, next) = one(rest)?;
        expressions.push(expression);
        rest = next;
    }
    Ok(expressions)
}

/// The first expression, and what comes after it.
fn one(pieces: &[String]) -> Result<(Expression, &[String]), String> {
    match pieces {
        [] => Err("a bracket is not closed".to_owned()),
        [open, rest @ ..] if open == "(" => {
            let (mut parts, mut rest) = (Vec::new(), rest);
            while rest.first().is_some_and(|piece| piece != ")") {
                let (part, next) = one(rest)?;
                parts.push(part);
                rest = next;
            }
            let rest = rest.get(1..).ok_or("a bracket is not closed")?;
            Ok((Expression::List(parts), rest))
        }
        [close, ..] if close == ")" => Err("a bracket is closed that was not opened".to_owned()),
        [word, rest @ ..] => Ok((atom(word), rest)),
    }
}

fn atom(word: &str) -> Expression {
    if let Some(text) = word.strip_prefix('"') {
        return Expression::Text(text.trim_end_matches('"').to_owned());
    }
    // Names such as inf and nan would be numbers to Rust.
    let number = word.parse().ok().filter(|_| word.contains(|letter: char| letter.is_ascii_digit()));
    number.map_or_else(|| Expression::Word(word.to_owned()), Expression::Number)
}

/// Brackets, texts and words; comments are left out.
fn pieces(source: &str) -> Vec<String> {
    let mut pieces = vec![String::new()];
    let (mut in_text, mut in_comment) = (false, false);
    for letter in source.chars() {
        let last = pieces.last_mut().expect("there is always one");
        match letter {
            '\n' if in_comment => in_comment = false,
            _ if in_comment => {}
            '"' => {
                last.push(letter);
                in_text = !in_text;
            }
            _ if in_text => last.push(letter),
            ';' => in_comment = true,
            '(' | ')' => pieces.extend([letter.to_string(), String::new()]),
            _ if letter.is_whitespace() => pieces.push(String::new()),
            _ => last.push(letter),
        }
    }
    pieces.retain(|piece| !piece.is_empty());
    pieces
}
