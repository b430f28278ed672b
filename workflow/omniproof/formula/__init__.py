"""The language of formulas: a printed line as a term that nothing has simplified."""
