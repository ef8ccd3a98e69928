"""The thesis's tables, figures, numbers and findings beside Continua's: what scripts/reproduce-thesis is made of."""
