"""The motion mathematics against published figures and independent integration."""
