"""What a Copley drive takes: points, serial words, packets of CAN frames."""
