"""Audit what papers on omnidirectional robots print against what their mechanics implies."""
