//! FPCore 2.0 (fpbench.org) as far as the snippets use it: parsed, and evaluated in f64 or with every operation rounded
//! to the precision that a core asks for.

mod parse;

use std::collections::HashMap;

pub use parse::Expression;

/// A function.
#[derive(Clone, Debug)]
pub struct Core {
    /// What it is called.
    pub symbol: String,
    /// Names of its arguments.
    pub arguments: Vec<String>,
    /// Properties by their keys.
    pub properties: HashMap<String, Expression>,
    body: Expression,
}

/// The cores of a file.
///
/// # Errors
/// What is wrong with it.
pub fn cores(source: &str) -> Result<Vec<Core>, String> {
    parse::all(source)?.iter().map(Core::of).collect()
}

type Names = HashMap<String, f64>;

/// A number or a truth.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Value {
    Number(f64),
    Truth(bool),
}

impl Core {
    /// `(FPCore symbol (arguments) properties body)`.
    fn of(expression: &Expression) -> Result<Self, String> {
        let Expression::List(parts) = expression else { return Err(format!("{expression:?} is no core")) };
        let [Expression::Word(head), Expression::Word(symbol), Expression::List(arguments), rest @ ..] = &parts[..]
        else {
            return Err("a core begins with FPCore, a symbol and a list of arguments".to_owned());
        };
        let [properties @ .., body] = rest else { return Err(format!("{symbol} has no body")) };
        if head != "FPCore" || properties.len() % 2 == 1 {
            return Err(format!("{symbol}: {head}, {} words of properties", properties.len()));
        }
        let property = |pair: &[Expression]| match pair {
            [Expression::Word(key), value] if key.starts_with(':') => Ok((key.clone(), value.clone())),
            _ => Err(format!("{symbol}: {pair:?} is no property")),
        };
        let argument = |argument: &Expression| match argument {
            Expression::Word(name) => Ok(name.clone()),
            other => Err(format!("{symbol}: {other:?} is no argument")),
        };
        Ok(Self {
            symbol: symbol.clone(),
            arguments: arguments.iter().map(argument).collect::<Result<_, _>>()?,
            properties: properties.chunks(2).map(property).collect::<Result<_, _>>()?,
            body: body.clone(),
        })
    }

    /// The body in f64, or with every operation rounded to f32.
    ///
    /// # Errors
    /// What is not understood.
    pub fn value(&self, arguments: &[f64], single: bool) -> Result<f64, String> {
        self.evaluate(&self.body, arguments, single)?.number()
    }

    /// What the core is to be exactly, in f64.
    ///
    /// # Errors
    /// What is not understood, or missing.
    pub fn specified(&self, arguments: &[f64]) -> Result<f64, String> {
        let spec = self.properties.get(":spec").ok_or_else(|| format!("{} has no :spec", self.symbol))?;
        self.evaluate(spec, arguments, false)?.number()
    }

    /// Whether the arguments are what the core asks for.
    ///
    /// # Errors
    /// What is not understood, or missing.
    pub fn admits(&self, arguments: &[f64]) -> Result<bool, String> {
        let pre = self.properties.get(":pre").ok_or_else(|| format!("{} has no :pre", self.symbol))?;
        self.evaluate(pre, arguments, false)?.truth()
    }

    fn evaluate(&self, expression: &Expression, arguments: &[f64], single: bool) -> Result<Value, String> {
        if arguments.len() != self.arguments.len() {
            return Err(format!("{} takes {} arguments", self.symbol, self.arguments.len()));
        }
        let names = self.arguments.iter().cloned().zip(arguments.iter().copied()).collect();
        Machine { single }.value(expression, &names)
    }
}

impl Value {
    fn number(self) -> Result<f64, String> {
        if let Self::Number(number) = self { Ok(number) } else { Err(format!("{self:?} is no number")) }
    }

    fn truth(self) -> Result<bool, String> {
        if let Self::Truth(truth) = self { Ok(truth) } else { Err(format!("{self:?} is no truth")) }
    }
}

struct Machine {
    single: bool,
}

impl Machine {
    fn rounded(&self, exact: f64) -> Value {
        Value::Number(if self.single { f64::from(exact as f32) } else { exact })
    }

    fn value(&self, expression: &Expression, names: &Names) -> Result<Value, String> {
        match expression {
            Expression::Number(number) => Ok(self.rounded(*number)),
            Expression::Word(word) => match (names.get(word), word.as_str()) {
                (Some(number), _) => Ok(Value::Number(*number)),
                (None, "PI") => Ok(self.rounded(std::f64::consts::PI)),
                _ => Err(format!("nothing is called {word}")),
            },
            Expression::List(parts) => match &parts[..] {
                [Expression::Word(head), parts @ ..] => self.operation(head, parts, names),
                _ => Err(format!("{expression:?} has no operator")),
            },
            Expression::Text(text) => Err(format!("a text, {text:?}, where a number is wanted")),
        }
    }

    fn operation(&self, head: &str, parts: &[Expression], names: &Names) -> Result<Value, String> {
        match (head, parts) {
            ("let*", [Expression::List(bindings), body]) => self.bound(bindings, body, names),
            ("if", [condition, yes, no]) => {
                let chosen = if self.value(condition, names)?.truth()? { yes } else { no };
                self.value(chosen, names)
            }
            ("and", parts) => {
                let all = parts.iter().try_fold(true, |all, part| Ok(all && self.value(part, names)?.truth()?));
                all.map(Value::Truth)
            }
            _ => {
                let numbers: Result<Vec<_>, String> =
                    parts.iter().map(|part| self.value(part, names)?.number()).collect();
                self.function(head, &numbers?)
            }
        }
    }

    fn bound(&self, bindings: &[Expression], body: &Expression, names: &Names) -> Result<Value, String> {
        let mut names = names.clone();
        for binding in bindings {
            let Expression::List(pair) = binding else { return Err(format!("{binding:?} binds nothing")) };
            let [Expression::Word(name), value] = &pair[..] else { return Err(format!("{pair:?} binds nothing")) };
            let value = self.value(value, &names)?.number()?;
            names.insert(name.clone(), value);
        }
        self.value(body, &names)
    }

    fn function(&self, name: &str, numbers: &[f64]) -> Result<Value, String> {
        let ordered =
            |holds: fn(&f64, &f64) -> bool| Ok(Value::Truth(numbers.windows(2).all(|pair| holds(&pair[0], &pair[1]))));
        match (name, numbers) {
            ("<", _) => return ordered(f64::lt),
            ("<=", _) => return ordered(f64::le),
            (">", _) => return ordered(f64::gt),
            (">=", _) => return ordered(f64::ge),
            _ => {}
        }
        let exact = match (name, numbers) {
            ("+", [a, b]) => a + b,
            ("*", [a, b]) => a * b,
            ("-", [a]) => -a,
            ("-", [a, b]) => a - b,
            ("/", [a, b]) => a / b,
            ("sqrt", [a]) => a.sqrt(),
            ("fmin", [a, b]) => a.min(*b),
            _ => return Err(format!("{name} of {} numbers is not known", numbers.len())),
        };
        Ok(self.rounded(exact))
    }
}
