"""The motion mathematics against published figures, closed forms and an independent integration."""
