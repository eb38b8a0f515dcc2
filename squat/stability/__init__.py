"""What the equations of motion imply without running them."""
