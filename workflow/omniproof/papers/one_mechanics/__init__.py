"""What the five papers say together: theorems, drawings and notation; nothing here is printed."""
