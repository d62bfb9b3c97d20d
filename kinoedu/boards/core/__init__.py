"""What every board stands on: the canvas, the scene, the drawing, and the board as a picture."""
