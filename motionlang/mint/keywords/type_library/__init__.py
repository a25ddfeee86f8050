"""The words of Mint's type library (build 5626) and of its console, as printed there."""
