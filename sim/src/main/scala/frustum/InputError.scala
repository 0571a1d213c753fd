package frustum

final case class InputError(message: String) extends RuntimeException(message)
