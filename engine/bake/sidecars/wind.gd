# Gives the wind to all shaders as global uniforms. Add it as an autoload (Project Settings > Globals) after adding the
# global shader uniforms wind_frames (sampler2DArray) and wind_seconds (float) in Project Settings > Shader Globals.
extends Node

@export var frames: Texture2DArray = preload("@FRAMES_FILE@")
var seconds := 0.0

func _ready() -> void:
	RenderingServer.global_shader_parameter_set("wind_frames", frames)

func _process(delta: float) -> void:
	seconds += delta
	RenderingServer.global_shader_parameter_set("wind_seconds", seconds)
