"""What a paper prints: its data model, the LaTeX reader, and the loader with its messages."""
