"""Tables, figures and fragments that the book shows; it formats and never decides."""
