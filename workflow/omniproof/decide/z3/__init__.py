"""The third engine: z3 looks for real numbers at which a printed statement fails."""
