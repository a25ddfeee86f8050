"""What runs a program: source, languages, controller, planners, servo and log. It imports no house."""
