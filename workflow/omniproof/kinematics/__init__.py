"""First principles: the mechanics behind the papers, written once."""
