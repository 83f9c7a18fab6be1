//! Runs functions of naga's intermediate representation, with the arithmetic that a test asks for.

mod arithmetic;

pub use arithmetic::{Arithmetic, Width};

use naga::{
    Arena, BinaryOperator, Block, Expression, Function, Handle, Literal, MathFunction, Module, Statement, Type,
    TypeInner, UnaryOperator,
};

use crate::{Program, Value};

impl Program {
    /// Calls the function of this name.
    ///
    /// # Panics
    /// Where there is none, and at whatever the snippets do not use.
    pub fn call(&self, name: &str, arguments: &[Value], arithmetic: &Arithmetic) -> Value {
        let mut functions = self.module.functions.iter().map(|(_, function)| function);
        let function = functions.find(|function| function.name.as_deref() == Some(name));
        let function = function.unwrap_or_else(|| panic!("no function {name}"));
        Call::of(&self.module, function, arguments.to_vec(), arithmetic).run()
    }
}

/// A function while it runs.
struct Call<'a> {
    module: &'a Module,
    function: &'a Function,
    arguments: Vec<Value>,
    locals: Vec<Option<Value>>,
    known: Vec<Option<Value>>,
    arithmetic: &'a Arithmetic,
}

impl<'a> Call<'a> {
    fn of(module: &'a Module, function: &'a Function, arguments: Vec<Value>, arithmetic: &'a Arithmetic) -> Self {
        let locals = vec![None; function.local_variables.len()];
        let known = vec![None; function.expressions.len()];
        Self { module, function, arguments, locals, known, arithmetic }
    }

    fn run(mut self) -> Value {
        for (handle, local) in self.function.local_variables.iter() {
            self.locals[handle.index()] = local.init.map(|init| self.value(init));
        }
        self.block(&self.function.body).expect("a function that gives a value")
    }

    /// The value that the block returns, if it does.
    fn block(&mut self, block: &'a Block) -> Option<Value> {
        block.iter().find_map(|statement| self.statement(statement))
    }

    fn statement(&mut self, statement: &'a Statement) -> Option<Value> {
        match statement {
            Statement::Emit(range) => range.clone().for_each(|handle| {
                self.known[handle.index()] = Some(self.evaluate(handle));
            }),
            Statement::Block(block) => return self.block(block),
            Statement::If { condition, accept, reject } => {
                let chosen = if self.value(*condition).truth() { accept } else { reject };
                return self.block(chosen);
            }
            Statement::Return { value } => return value.map(|value| self.value(value)),
            Statement::Store { pointer, value } => {
                let value = self.value(*value);
                self.store(*pointer, value);
            }
            Statement::Call { function, arguments, result } => {
                let arguments = arguments.iter().map(|&argument| self.value(argument)).collect();
                let function = &self.module.functions[*function];
                let value = Call::of(self.module, function, arguments, self.arithmetic).run();
                if let Some(result) = result {
                    self.known[result.index()] = Some(value);
                }
            }
            other => panic!("no snippet has {other:?}"),
        }
        None
    }

    fn store(&mut self, pointer: Handle<Expression>, value: Value) {
        match self.value(pointer) {
            Value::Place(local, None) => self.locals[local] = Some(value),
            other => panic!("no snippet stores to {other:?}"),
        }
    }

    fn load(&self, pointer: Value) -> Value {
        let Value::Place(local, lane) = pointer else { panic!("{pointer:?} is no place") };
        let value = self.locals[local].expect("a variable that has been set");
        lane.map_or(value, |lane| Value::Number(value.vector()[lane]))
    }

    /// What has been computed, or needs no computing.
    fn value(&mut self, handle: Handle<Expression>) -> Value {
        self.known[handle.index()].unwrap_or_else(|| self.evaluate(handle))
    }

    fn evaluate(&mut self, handle: Handle<Expression>) -> Value {
        match &self.function.expressions[handle] {
            &Expression::FunctionArgument(place) => self.arguments[place as usize],
            Expression::LocalVariable(local) => Value::Place(local.index(), None),
            &Expression::Load { pointer } => {
                let place = self.value(pointer);
                self.load(place)
            }
            &Expression::AccessIndex { base, index } => match self.value(base) {
                Value::Place(local, None) => Value::Place(local, Some(index as usize)),
                base => Value::Number(base.vector()[index as usize]),
            },
            &Expression::Unary { op: UnaryOperator::Negate, expr } => self.value(expr).map(|number| -number),
            &Expression::Unary { op: UnaryOperator::LogicalNot, expr } => Value::Truth(!self.value(expr).truth()),
            &Expression::Binary { op, left, right } => {
                let sum = [BinaryOperator::Add, BinaryOperator::Subtract].contains(&op);
                let operands = [left, right].map(|operand| self.operand(operand, sum));
                self.binary(op, operands)
            }
            &Expression::Select { condition, accept, reject } => {
                let [accept, reject] = [accept, reject].map(|operand| self.value(operand));
                if self.value(condition).truth() { accept } else { reject }
            }
            &Expression::Math { fun, arg, arg1, arg2, .. } => {
                let arguments: Vec<_> = [Some(arg), arg1, arg2].into_iter().flatten().collect();
                let arguments: Vec<_> = arguments.into_iter().map(|argument| self.value(argument)).collect();
                self.math(fun, &arguments)
            }
            &Expression::As { expr, .. } => self.value(expr),
            _ => self.constant(&self.function.expressions, handle),
        }
    }

    /// A value, or in a sum, where products are fused with it, the product as it is before it is rounded.
    fn operand(&mut self, handle: Handle<Expression>, sum: bool) -> Value {
        match self.function.expressions[handle] {
            Expression::Binary { op: BinaryOperator::Multiply, left, right } if sum && self.arithmetic.fuses() => {
                let [left, right] = [left, right].map(|factor| self.value(factor));
                left.zip(right, |a, b| a * b)
            }
            _ => self.value(handle),
        }
    }

    /// What is made of constants alone.
    fn constant(&mut self, expressions: &'a Arena<Expression>, handle: Handle<Expression>) -> Value {
        let own = std::ptr::eq(expressions, &self.function.expressions);
        let part = |call: &mut Self, part| if own { call.value(part) } else { call.constant(expressions, part) };
        match &expressions[handle] {
            &Expression::Literal(literal) => self.literal(literal),
            &Expression::Constant(constant) => {
                let init = self.module.constants[constant].init;
                self.constant(&self.module.global_expressions, init)
            }
            &Expression::ZeroValue(ty) => zero(&self.module.types[ty]),
            &Expression::Splat { value, .. } => Value::Vector([part(self, value).number(); 3]),
            Expression::Compose { components, .. } => {
                let lanes: Vec<_> = components.iter().map(|&lane| part(self, lane).number()).collect();
                Value::Vector(lanes.try_into().expect("three lanes"))
            }
            other => panic!("no snippet has {other:?}"),
        }
    }

    fn literal(&self, literal: Literal) -> Value {
        match literal {
            Literal::F32(number) => Value::Number(self.arithmetic.rounded(number.into())),
            Literal::F16(number) => Value::Number(number.into()),
            Literal::Bool(truth) => Value::Truth(truth),
            other => panic!("no snippet has {other:?}"),
        }
    }

    fn binary(&self, op: BinaryOperator, [left, right]: [Value; 2]) -> Value {
        let arithmetic = self.arithmetic;
        let rounded = |f: fn(f64, f64) -> f64| left.zip(right, |a, b| arithmetic.rounded(f(a, b)));
        let compared = |f: fn(&f64, &f64) -> bool| Value::Truth(f(&left.number(), &right.number()));
        match op {
            BinaryOperator::Add => rounded(|a, b| a + b),
            BinaryOperator::Subtract => rounded(|a, b| a - b),
            BinaryOperator::Multiply => rounded(|a, b| a * b),
            BinaryOperator::Divide => left.zip(right, |a, b| arithmetic.quotient(a, b)),
            BinaryOperator::Less => compared(f64::lt),
            BinaryOperator::LessEqual => compared(f64::le),
            BinaryOperator::Greater => compared(f64::gt),
            BinaryOperator::GreaterEqual => compared(f64::ge),
            BinaryOperator::LogicalAnd => Value::Truth(left.truth() && right.truth()),
            BinaryOperator::LogicalOr => Value::Truth(left.truth() || right.truth()),
            other => panic!("no snippet has {other:?}"),
        }
    }

    fn math(&self, fun: MathFunction, arguments: &[Value]) -> Value {
        let arithmetic = self.arithmetic;
        match (fun, arguments) {
            (MathFunction::Abs, [a]) => a.map(f64::abs),
            (MathFunction::Min, [a, b]) => a.zip(*b, f64::min),
            (MathFunction::Max, [a, b]) => a.zip(*b, f64::max),
            (MathFunction::Sqrt, [a]) => a.map(|square| arithmetic.root(square)),
            (MathFunction::InverseSqrt, [a]) => a.map(|square| arithmetic.inverse_root(square)),
            (MathFunction::Dot, [a, b]) => Value::Number(arithmetic.dot(a.vector(), b.vector())),
            (MathFunction::Reflect, [i, n]) => {
                let twice = 2.0 * arithmetic.dot(n.vector(), i.vector());
                i.zip(*n, |i, n| arithmetic.rounded(i - arithmetic.rounded(twice * n)))
            }
            (other, _) => panic!("no snippet has {other:?} of {} arguments", arguments.len()),
        }
    }
}

fn zero(ty: &Type) -> Value {
    match ty.inner {
        TypeInner::Scalar(_) => Value::Number(0.0),
        TypeInner::Vector { .. } => Value::Vector([0.0; 3]),
        ref other => panic!("no snippet has a {other:?}"),
    }
}
