"""The engines, asked about what derivations give: expressions of SymPy."""
