"""The parts that all boards share: canvas, scene, drawing, and a board as a picture."""
