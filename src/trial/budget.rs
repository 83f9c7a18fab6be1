//! The error budgets.
